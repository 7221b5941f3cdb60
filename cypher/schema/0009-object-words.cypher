// People search labels by words.
// mode: write
CREATE FULLTEXT INDEX object_words IF NOT EXISTS FOR (o:Object) ON EACH [o.label]
