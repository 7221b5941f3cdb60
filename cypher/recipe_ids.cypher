// The ids of the recipes that surely belong to a dish type, of one partition or, for '', of all.
// param: dish_type STRING
// param: partition STRING
// column: id
// mode: read
MATCH (:DishType {name: $dish_type})<-[kind:KIND_OF]-(r:Recipe)
WHERE kind.sure AND $partition IN ['', r.partition]
RETURN r.id AS id
ORDER BY id
