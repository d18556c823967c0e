#pragma once

// What core/parallel.hpp takes from TBB, for programs that have one thread: a Worker of a browser.

namespace tbb {

template <class Number>
class blocked_range {
 public:
  blocked_range(Number begin, Number end) : begin_(begin), end_(end) {}
  Number begin() const { return begin_; }
  Number end() const { return end_; }

 private:
  Number begin_, end_;
};

template <class Range, class Body>
void parallel_for(const Range& range, const Body& body) {
  body(range);
}

}  // namespace tbb
