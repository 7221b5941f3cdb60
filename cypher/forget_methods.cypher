// Takes away all that was learnt of the FOON: operators and frames with everything that speaks of them.
// mode: write
// scans: everything that was learnt goes
MATCH (n:Frame|Line|Matter|Operator|Post|Slot|Stage|Utensil)
DETACH DELETE n
