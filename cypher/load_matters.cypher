// Makes the foods, kinds and forms of food and the appliances that operators and frames speak of and that are not there yet.
// param: foods LIST<MAP>
// param: kinds LIST<STRING>
// param: forms LIST<STRING>
// param: appliances LIST<STRING>
// param: anything LIST<STRING>
// mode: write
CALL () {
  UNWIND $foods AS row
  MERGE (m:Matter {name: row.name})
    ON CREATE SET m:Food, m.kind = row.kind
}
CALL () {
  UNWIND $kinds AS name
  MERGE (m:Matter {name: name})
    ON CREATE SET m:Kind
}
CALL () {
  UNWIND $forms AS name
  MERGE (m:Matter {name: name})
    ON CREATE SET m:Form
}
CALL () {
  UNWIND $appliances AS name
  MERGE (m:Matter {name: name})
    ON CREATE SET m:Appliance
}
CALL () {
  UNWIND $anything AS name
  MERGE (:Matter {name: name})
}
