// The goals of a video are found by its name.
// mode: write
CREATE INDEX goal_video IF NOT EXISTS FOR ()-[goal:IS_A]-() ON (goal.video)
