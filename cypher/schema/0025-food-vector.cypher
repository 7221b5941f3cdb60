// The foods to which something like the asked food is done are found by the same points as the ingredients.
// mode: write
CREATE VECTOR INDEX food_vector IF NOT EXISTS FOR (m:Food) ON (m.vector)
OPTIONS {indexConfig: {
  `vector.dimensions`: 190,
  `vector.similarity_function`: 'cosine',
  `vector.quantization.enabled`: false,
  `vector.hnsw.m`: 32,
  `vector.hnsw.ef_construction`: 200
}}
