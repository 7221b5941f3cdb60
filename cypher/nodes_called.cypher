// Every object node with one of the labels.
// param: labels LIST<STRING>
// column: nodes
// mode: read
UNWIND $labels AS label
MATCH (o:Object {label: label})
USING INDEX SEEK o:Object(label)
RETURN collect([o.label, o.states, o.ingredients, o.relation, o.container]) AS nodes
