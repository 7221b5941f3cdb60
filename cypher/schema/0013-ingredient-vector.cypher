// The foods that may stand for another are found by the points of foon_kg/similarity/points.py. They are few and
// small: more neighbours are kept than usual, and all bits, so that the search misses none.
// mode: write
CREATE VECTOR INDEX ingredient_vector IF NOT EXISTS FOR (i:Ingredient) ON (i.vector)
OPTIONS {indexConfig: {
  `vector.dimensions`: 190,
  `vector.similarity_function`: 'cosine',
  `vector.quantization.enabled`: false,
  `vector.hnsw.m`: 32,
  `vector.hnsw.ef_construction`: 200
}}
