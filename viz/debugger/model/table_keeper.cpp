#include "viz/debugger/model/table_keeper.h"

namespace kerf {

void TableKeeper::update(Run& run, const TableWish& wish) {
  const bool is_now = wish.of == TableOf::errors || position_ == run.position();
  const bool is_kept = run_ == &run && is_now && wish_.of == wish.of;
  if (is_kept && wish_ == wish) return;
  if (!is_kept) table_ = make_table(run, wish.of);
  rows_ = find_rows(table_, wish.text, wish.order);
  run_ = &run;
  position_ = run.position();
  wish_ = wish;
}

}  // namespace kerf
