# What the default tests try for a moment, `./run soak` tries for as long as it is told.
kerf_parts(property kerf_core)
kerf_tests(property kerf_core)
kerf_parts(fuzz/tree kerf_property_parts)
kerf_tests(fuzz/tree kerf_core)
