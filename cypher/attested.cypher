// Which operator each of the named units attests, what it does there to what, and what of that it changes.
// param: keys LIST<STRING>
// column: attested
// mode: read
UNWIND $keys AS key
MATCH (m:Motion {key: key})<-[a:ATTESTED_BY]-(o:Operator)
RETURN collect([key, o.key, a.done_to, a.changes]) AS attested
