#include "devo_evo/soft_body/text.h"

#include "soft_body/state_hash.h"

#include <gtest/gtest.h>

#include <limits>
#include <locale>

using namespace devo_evo;

namespace
{
/// As many languages write numbers: 1.234,5
struct CommaPunctuation : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};
}  // namespace

TEST(Text, ofANumberIsTheShortestThatReadsBackTheSame)
{
  EXPECT_EQ("0.1", toText(0.1));
  EXPECT_EQ("0.30000000000000004", toText(0.1 + 0.2));
  EXPECT_EQ("10", toText(10.0));
  EXPECT_EQ("1e-07", toText(1e-7));
  EXPECT_EQ("-0", toText(-0.0));
  EXPECT_EQ("5e-324", toText(5e-324));
  EXPECT_EQ("1.7976931348623157e+308", toText(std::numeric_limits<double>::max()));
  EXPECT_EQ("inf", toText(std::numeric_limits<double>::infinity()));
}

TEST(Text, ofWholeNumbers)
{
  EXPECT_EQ("42149", toText(42149));
  EXPECT_EQ("-9223372036854775808", toText(std::numeric_limits<int64_t>::min()));
}

TEST(Text, ofAHashIs16HexadecimalDigits)
{
  EXPECT_EQ("0123456789abcdef", hashToString(0x0123456789abcdefu));
  EXPECT_EQ("0000000000000000", hashToString(0));
  EXPECT_EQ("ffffffffffffffff", hashToString(~uint64_t{ 0 }));
}

TEST(Text, isTheSameInEveryLocale)
{
  const std::locale before = std::locale::global(std::locale(std::locale(), new CommaPunctuation));
  EXPECT_EQ("12345.5", toText(12345.5));
  EXPECT_EQ("12345", toText(12345));
  std::locale::global(before);
}

TEST(StateHash, isTheStartOfSha256OverLittleEndianNumbersAndFlags)
{
  // Python: hashlib.sha256(struct.pack('<d', 1.5) + b'\x01' + struct.pack('<d', 0.0)
  //                        + struct.pack('<Q', 0x0123456789abcdef) + b'\x00').hexdigest()[:16]
  StateHash hash;
  hash.add(1.5);
  hash.add(true);
  hash.add(-0.0);  // counts as zero
  hash.add(uint64_t{ 0x0123456789abcdef });
  hash.add(false);
  EXPECT_EQ("bbb8186ad7c83cda", hashToString(hash.finish()));
}

TEST(StateHash, ofNothingIsThatOfAnEmptyMessage)
{
  EXPECT_EQ("e3b0c44298fc1c14", hashToString(StateHash().finish()));
}
