// Operators are asked for by motion.
// mode: write
CREATE INDEX operator_motion IF NOT EXISTS FOR (o:Operator) ON (o.motion)
