// Whether there is anything in the database at all.
// column: something
// mode: read
// scans: the first node answers it
RETURN EXISTS { (n) } AS something
