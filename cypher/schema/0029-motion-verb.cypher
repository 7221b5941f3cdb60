// Units are found by what is done in them.
// mode: write
CREATE INDEX motion_verb IF NOT EXISTS FOR (m:Motion) ON (m.verb)
