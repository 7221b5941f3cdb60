// A graph of a schema before this one called a type of stages a Post. Its nodes go when it is learnt from anew. No step
// makes this constraint any more: who made it beside a loader that is already here would wait for that one, and it for him.
// mode: write
DROP CONSTRAINT post_name IF EXISTS
