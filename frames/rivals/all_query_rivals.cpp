// The libraries that answer queries (KERF_RIVALS); without them no_rivals.cpp stands in their place.

#include "frames/rivals/flat_queries.h"
#include "frames/rivals/makers.h"

namespace kerf {

template <>
std::vector<std::unique_ptr<QueryRival<3>>> query_rivals<3>() {
  std::vector<std::unique_ptr<QueryRival<3>>> all;
  all.push_back(make_bullet_queries());
  all.push_back(make_fcl_queries());
  all.push_back(make_embree_queries());
  return all;
}

template <>
std::vector<std::unique_ptr<QueryRival<2>>> query_rivals<2>() {
  std::vector<std::unique_ptr<QueryRival<2>>> all;
  all.push_back(make_box2d_queries());
  all.push_back(std::make_unique<FlatQueries>(make_bullet_queries()));
  all.push_back(std::make_unique<FlatQueries>(make_fcl_queries()));
  all.push_back(std::make_unique<FlatQueries>(make_embree_queries()));
  return all;
}

}  // namespace kerf
