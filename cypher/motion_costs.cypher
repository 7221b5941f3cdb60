// The weights of motions that were loaded last: as many costs as motions, in the same order.
// column: motions
// column: costs
// mode: read
MATCH (f:Foon {name: 'foon-kg'})
RETURN coalesce(f.cost_motions, []) AS motions, coalesce(f.costs, []) AS costs
