// Frames are asked for by dish type.
// mode: write
CREATE INDEX frame_dish_type IF NOT EXISTS FOR (f:Frame) ON (f.dish_type)
