// All frames, each as the text from which it is read.
// column: frames
// mode: read
// scans: all frames are asked for
MATCH (f:Frame)
RETURN collect(f.text) AS frames
