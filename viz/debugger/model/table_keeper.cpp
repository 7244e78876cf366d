#include "viz/debugger/model/table_keeper.h"

namespace kerf {

void TableKeeper::update(Run& run, const TableWish& wish) {
  const bool is_kept = run_ == &run && position_ == run.position() && wish_.pairs == wish.pairs;
  if (is_kept && wish_ == wish) return;
  if (!is_kept) table_ = wish.pairs ? table_of_pairs(run) : table_of_nodes(run);
  rows_ = find_rows(table_, wish.text, wish.order);
  run_ = &run;
  position_ = run.position();
  wish_ = wish;
}

}  // namespace kerf
