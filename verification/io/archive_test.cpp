#include "io/archive.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace tdbd::archive_test {

enum class Colour { red, blue };

/// A struct with a member of every kind.
struct Inner {
  double real = 0.0;
  bool flag = false;

  template <class A>
  void serialize(A& a) {
    a(real, flag);
  }
  bool operator==(const Inner&) const = default;
};

struct Outer {
  long whole = 0;
  Colour colour = Colour::red;
  std::string text;
  Vec3 vector = Vec3::Zero();
  std::array<int, 3> three{};
  std::vector<std::vector<int>> lists;
  std::vector<Inner> inner;
  std::optional<Inner> maybe;
  std::pair<double, std::string> pair;

  template <class A>
  void serialize(A& a) {
    a(whole, colour, text, vector, three, lists, inner, maybe, pair);
  }
  bool operator==(const Outer&) const = default;
};

Inner any_inner() { return {*rc::gen::arbitrary<int>() * 0.5, *rc::gen::arbitrary<bool>()}; }

Outer any_outer() {
  Outer x{*rc::gen::arbitrary<long>(),
          *rc::gen::element(Colour::red, Colour::blue),
          *rc::gen::string<std::string>(),
          {1.0, -0.0, *rc::gen::arbitrary<int>() * 0.25},
          {1, 2, *rc::gen::arbitrary<int>()},
          *rc::gen::arbitrary<std::vector<std::vector<int>>>(),
          {},
          std::nullopt,
          {*rc::gen::arbitrary<int>() * 0.125, *rc::gen::string<std::string>()}};
  for (int k = *rc::gen::inRange(0, 4); k > 0; --k) x.inner.push_back(any_inner());
  if (*rc::gen::arbitrary<bool>()) x.maybe = any_inner();
  return x;
}

Archive archive_of(const Outer& x) {
  ArchiveWriter write;
  write(x);
  return std::move(write).archive();
}

RC_GTEST_PROP(Archive, reads_back_what_was_written, ()) {
  const Outer x = any_outer();
  const Archive archive = archive_of(x);
  Outer y;
  y.maybe = Inner{1.0, true};
  ArchiveReader read(archive.bytes);
  read(y);
  read.require_end(archive.layout);
  RC_ASSERT(y == x);
}

/// Torn anywhere, with sizes and all else as they were.
RC_GTEST_PROP(Archive, that_ends_too_early_is_rejected, ()) {
  const Archive archive = archive_of(any_outer());
  const auto kept = *rc::gen::inRange<std::size_t>(0, archive.bytes.size());
  Outer y;
  ArchiveReader read(std::string_view(archive.bytes).substr(0, kept));
  RC_ASSERT_THROWS_AS(read(y), RunError);
}

/// Any bytes: they are read or refused, and take no more memory than they could describe.
RC_GTEST_PROP(Archive, of_any_bytes_is_read_or_rejected, (const std::string& bytes)) {
  Outer y;
  ArchiveReader read(bytes);
  try {
    read(y);
  } catch (const RunError&) {
    return;
  }
  RC_ASSERT(y.inner.size() + y.lists.size() <= bytes.size());
}

TEST(Archive, of_other_types_is_rejected) {
  ArchiveWriter write;
  write(1.0, 2L);
  const Archive archive = std::move(write).archive();
  double real = 0.0;
  long whole = 0;
  ArchiveReader same(archive.bytes), swapped(archive.bytes), fewer(archive.bytes);
  same(real, whole);
  EXPECT_NO_THROW(same.require_end(archive.layout));
  swapped(whole, real);
  EXPECT_THROW(swapped.require_end(archive.layout), RunError);
  fewer(real);
  EXPECT_THROW(fewer.require_end(archive.layout), RunError);
}

}  // namespace tdbd::archive_test
