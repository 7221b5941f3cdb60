// Object nodes are asked for by label.
// mode: write
CREATE INDEX object_label IF NOT EXISTS FOR (o:Object) ON (o.label)
