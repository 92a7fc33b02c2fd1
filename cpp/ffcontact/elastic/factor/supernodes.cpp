// SPDX-License-Identifier: GPL-3.0-or-later
#include "ffcontact/elastic/factor/supernodes.hpp"

#include <cholmod.h>

#include <algorithm>
#include <new>
#include <string>

#include "ffcontact/base/require.hpp"

namespace ffcontact {

namespace {

/// CHOLMOD's workspace, silent: errors are read from its status.
class Session {
 public:
  Session() {
    cholmod_start(&common);
    common.print = 0;
    common.error_handler = nullptr;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nmethods = 1;
    common.method[0].ordering =
        CHOLMOD_NATURAL;  // the matrix comes in elimination order
    common.postorder = 0;
  }
  ~Session() { cholmod_finish(&common); }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  void require_memory() const {
    if (common.status == CHOLMOD_OUT_OF_MEMORY ||
        common.status == CHOLMOD_TOO_LARGE)
      throw std::bad_alloc();
  }
  mutable cholmod_common common;
};

template <class T>
using FreeFunction = int (*)(T**, cholmod_common*);

/// Owner of one CHOLMOD object.
template <class T, FreeFunction<T> free>
class Owned {
 public:
  Owned(T* object, const Session& session)
      : object_(object), session_(session) {
    if (object_) return;
    session.require_memory();
    throw Failure("CHOLMOD failed with status " +
                  std::to_string(session.common.status));
  }
  ~Owned() { free(&object_, &session_.common); }
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  T* operator->() const { return object_; }
  T* get() const { return object_; }

 private:
  T* object_;
  const Session& session_;
};
using OwnedSparse = Owned<cholmod_sparse, cholmod_free_sparse>;
using OwnedFactor = Owned<cholmod_factor, cholmod_free_factor>;

int* indices(void* p) { return static_cast<int*>(p); }

void copy(const std::vector<int>& from, void* to) {
  std::copy(from.begin(), from.end(), indices(to));
}

/// Room for the lower triangle of a pattern.
cholmod_sparse* pattern_of_size(std::size_t n, std::size_t entries,
                                const Session& session) {
  constexpr int sorted = 1, packed = 1, lower = -1;
  cholmod_sparse* room = cholmod_allocate_sparse(
      n, n, entries, sorted, packed, lower, CHOLMOD_PATTERN, &session.common);
  if (!room) throw std::bad_alloc();
  return room;
}

/// A graph as the lower triangle of a pattern.
cholmod_sparse* pattern(const Graph& graph, const Session& session) {
  const std::size_t entries = std::max<std::size_t>(1, graph.neighbours.size());
  cholmod_sparse* result =
      pattern_of_size(graph.vertex_count(), entries, session);
  copy(graph.start, result->p);
  copy(graph.neighbours, result->i);
  return result;
}

/// CHOLMOD's view of a lower triangle's pattern, which it only reads.
cholmod_sparse view_of(const SparseMatrix& lower) {
  cholmod_sparse view{};
  view.nrow = view.ncol = static_cast<std::size_t>(lower.cols());
  view.nzmax = static_cast<std::size_t>(lower.nonZeros());
  view.p = const_cast<int*>(lower.outerIndexPtr());
  view.i = const_cast<int*>(lower.innerIndexPtr());
  view.stype = -1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_PATTERN;
  view.dtype = CHOLMOD_DOUBLE;
  view.packed = 1;
  return view;
}

/// METIS's nested dissection, or minimum degree where METIS fails.
void put_order(cholmod_sparse* graph, const Session& session, int* order) {
  constexpr int postorder = 1;
  if (cholmod_metis(graph, nullptr, 0, postorder, order, &session.common))
    return;
  session.require_memory();
  if (!cholmod_amd(graph, nullptr, 0, order, &session.common))
    session.require_memory();
}

void append(int end_column, const int* rows, const int* end_of_rows,
            Supernodes& nodes) {
  nodes.first_column.push_back(end_column);
  nodes.rows.insert(nodes.rows.end(), rows, end_of_rows);
  nodes.first_row.push_back(nodes.rows.size());
}

}  // namespace

std::vector<int> dissection_order(const Graph& graph) {
  std::vector<int> order(graph.vertex_count());
  if (order.empty()) return order;
  const Session session;
  const OwnedSparse sparse(pattern(graph, session), session);
  put_order(sparse.get(), session, order.data());
  return order;
}

Supernodes supernodes(const SparseMatrix& lower, int eliminated) {
  const Session session;
  cholmod_sparse pattern = view_of(lower);
  const OwnedFactor L(cholmod_analyze(&pattern, &session.common), session);
  const int *column = indices(L->super), *start = indices(L->pi),
            *rows = indices(L->s);
  Supernodes result;
  for (std::size_t s = 0; s < L->nsuper && column[s] < eliminated; ++s) {
    const int end = std::min(column[s + 1], eliminated);
    for (int first = column[s]; first < end; first += widest_supernode)
      append(std::min(first + widest_supernode, end),
             rows + start[s] + (first - column[s]), rows + start[s + 1],
             result);
  }
  return result;
}

}  // namespace ffcontact
