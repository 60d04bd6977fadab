#pragma once
// WebAssembly has one thread: the loop of TBB, one turn after the other.

namespace tbb {

template <class Index, class Body>
void parallel_for(Index first, Index last, const Body& body) {
  for (Index i = first; i < last; ++i) body(i);
}

}  // namespace tbb
