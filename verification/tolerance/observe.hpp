#pragma once
// Records the share of its tolerance that each check uses. A build with TDBD_OBSERVE (preset mutate) includes this file first in
// every test; it replaces macros of GoogleTest and RapidCheck by others that also record both sides of the comparison.

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <mutex>
#include <optional>
#include <string>

namespace tdbd::observed {

/// The position of a check in its file, and the expression of its tolerance.
struct Place {
  const char* file;
  int line;
  const char* allowed;
};

/// The observations of one check, over all its evaluations.
struct Seen {
  long times = 0;
  double share = 0.0;     ///< largest ratio of observed to allowed
  double observed = 0.0;  ///< with that share
  double allowed = 0.0;   ///< with that share
  double scale =
      0.0;  ///< with that share: the larger of the two compared values; 0 if there is only one
};

/// All checks of this process. If the environment variable TDBD_OBSERVED names a folder, they are written
/// to it when the process ends: file, line, times, share, observed, allowed, scale, expression.
class Ledger {
 public:
  void note(const Place& place, double observed, double allowed, double scale = 0.0) {
    if (folder_ == nullptr || !(allowed > 0.0)) return;
    const std::lock_guard lock(mutex_);
    Seen& seen = checks_[{place.file, place.line, place.allowed}];
    ++seen.times;
    if (const double share = observed / allowed; seen.times == 1 || share > seen.share)
      seen = {seen.times, share, observed, allowed, scale};
  }

  ~Ledger() {
    if (folder_ == nullptr || checks_.empty()) return;
    const std::string name = std::string(folder_) + "/" + std::to_string(getpid()) + ".tsv";
    std::FILE* file = std::fopen(name.c_str(), "w");
    if (file == nullptr) std::abort();
    for (const auto& [key, seen] : checks_)
      std::fprintf(file, "%s\t%d\t%ld\t%.3g\t%.3g\t%.3g\t%.3g\t%s\n", std::get<0>(key).c_str(),
                   std::get<1>(key), seen.times, seen.share, seen.observed, seen.allowed,
                   seen.scale, std::get<2>(key).c_str());
    std::fclose(file);
  }

 private:
  const char* folder_ = std::getenv("TDBD_OBSERVED");
  std::mutex mutex_;
  std::map<std::tuple<std::string, int, std::string>, Seen> checks_;
};

inline Ledger& ledger() {
  static Ledger all;
  return all;
}

template <class T>
concept Real = std::floating_point<std::remove_cvref_t<T>>;

/// Records a comparison of two real numbers; others have no tolerance.
template <class A, class B>
void note_below(const Place& place, const A& a, const B& b) {
  if constexpr (Real<A> && Real<B>)
    ledger().note(place, static_cast<double>(a), static_cast<double>(b));
}

/// Replaces GoogleTest's comparison.
struct Less {
  Place place;
  template <class A, class B>
  testing::AssertionResult operator()(const char* a_words, const char* b_words, const A& a,
                                      const B& b) const {
    note_below(place, a, b);
    return testing::internal::CmpHelperLT(a_words, b_words, a, b);
  }
};

struct LessOrEqual {
  Place place;
  template <class A, class B>
  testing::AssertionResult operator()(const char* a_words, const char* b_words, const A& a,
                                      const B& b) const {
    note_below(place, a, b);
    return testing::internal::CmpHelperLE(a_words, b_words, a, b);
  }
};

struct Near {
  Place place;
  testing::AssertionResult operator()(const char* a_words, const char* b_words, const char* words,
                                      double a, double b, double most) const {
    ledger().note(place, std::abs(a - b), most, std::max(std::abs(a), std::abs(b)));
    return testing::internal::DoubleNearPredFormat(a_words, b_words, words, a, b, most);
  }
};

/// The left side of the expression in RC_ASSERT, if it is a real number: Check{place} <= a < b is parsed as
/// (Check{place} <= a) < b.
template <Real A>
struct Left {
  Place place;
  A a;
  template <class B>
  bool operator<(const B& b) const {
    note_below(place, a, b);
    return a < b;
  }
  template <class B>
  bool operator<=(const B& b) const {
    note_below(place, a, b);
    return a <= b;
  }
  operator A() const { return a; }
};

struct Check {
  Place place;
};

template <Real A>
Left<A> operator<=(const Check& check, const A& a) {
  return {check.place, a};
}

template <class A>
const A& operator<=(const Check&, const A& a) {
  return a;
}

/// Without this overload the standard's comparison of a value with an optional number would be chosen, which is false
/// for an empty one.
template <class A>
const std::optional<A>& operator<=(const Check&, const std::optional<A>& a) {
  return a;
}

}  // namespace tdbd::observed

#define TDBD_PLACE(words) (::tdbd::observed::Place{__FILE__, __LINE__, words})

#undef EXPECT_LT
#undef EXPECT_LE
#undef ASSERT_LT
#undef ASSERT_LE
#undef EXPECT_NEAR
#undef ASSERT_NEAR
#undef RC_ASSERT
#define EXPECT_LT(a, b) EXPECT_PRED_FORMAT2(::tdbd::observed::Less{TDBD_PLACE(#b)}, a, b)
#define EXPECT_LE(a, b) EXPECT_PRED_FORMAT2(::tdbd::observed::LessOrEqual{TDBD_PLACE(#b)}, a, b)
#define ASSERT_LT(a, b) ASSERT_PRED_FORMAT2(::tdbd::observed::Less{TDBD_PLACE(#b)}, a, b)
#define ASSERT_LE(a, b) ASSERT_PRED_FORMAT2(::tdbd::observed::LessOrEqual{TDBD_PLACE(#b)}, a, b)
#define EXPECT_NEAR(a, b, most) \
  EXPECT_PRED_FORMAT3(::tdbd::observed::Near{TDBD_PLACE(#most)}, a, b, most)
#define ASSERT_NEAR(a, b, most) \
  ASSERT_PRED_FORMAT3(::tdbd::observed::Near{TDBD_PLACE(#most)}, a, b, most)
#define RC_ASSERT(expression)                                                                     \
  RC_INTERNAL_CONDITIONAL_RESULT(                                                                 \
      Failure, static_cast<bool>(::tdbd::observed::Check{TDBD_PLACE(#expression)} <= expression), \
      true, "RC_ASSERT", )
