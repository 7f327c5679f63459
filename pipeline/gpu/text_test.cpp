// Texts and numbers for people. Figures are by hand; the code points' names are Unicode's.
#include "pipeline/gpu/text.hpp"

#include <cmath>
#include <limits>

#include "tests/support/catch.hpp"

using namespace caustics;

TEST_CASE("What moves a cursor, breaks a line or turns the direction of writing is shown as an escape") {
  CHECK(one_line("a\x1b[31mb\r\n\x7f") == "a\\x1b[31mb\\x0d\\x0a\\x7f");
  CHECK(one_line("\xc2\x80\xc2\x9b\xc2\x9f\xc2\xa0") ==
        "\\u0080\\u009b\\u009f\xc2\xa0");  // C1; no-break space
  CHECK(one_line("\xe2\x80\xae\xe2\x81\xa6\xe2\x80\x8f\xd8\x9c") == "\\u202e\\u2066\\u200f\\u061c");
  CHECK(one_line("\xe2\x80\xa8\xe2\x80\xa9\xef\xbb\xbf") == "\\u2028\\u2029\\ufeff");
  CHECK(one_line("\xf3\xa0\x81\x81") == "\\U000e0041");  // a tag
  CHECK(one_line("Gl\xc3\xa4ser \xe7\x8e\xbb \xf0\x9f\xa5\x82 5 %") ==
        "Gl\xc3\xa4ser \xe7\x8e\xbb \xf0\x9f\xa5\x82 5 %");
  // Cleaned once, it stays as it is.
  CHECK(one_line(one_line("\x1b\xc2\x9b")) == one_line("\x1b\xc2\x9b"));
}

TEST_CASE("Bytes that are no UTF-8 are shown one by one") {
  CHECK(one_line("a\xff") == "a\\xff");
  CHECK(one_line("\xc3") == "\\xc3");                             // cut short
  CHECK(one_line("\xc0\xaf") == "\\xc0\\xaf");                    // longer than need be
  CHECK(one_line("\xe0\x80\xaf") == "\\xe0\\x80\\xaf");           // likewise
  CHECK(one_line("\xed\xa0\x80") == "\\xed\\xa0\\x80");           // half of a UTF-16 pair
  CHECK(one_line("\xf4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");  // beyond Unicode
  CHECK(one_line("\x9b") == "\\x9b");                             // C1 in Latin-1
}

TEST_CASE("A long text is cut between two characters") {
  CHECK(one_line("abcdefgh", 8) == "abcdefgh");
  CHECK(one_line("abcdefghi", 8) == "abcde...");
  CHECK(one_line("abcd\xc3\xa4ghi", 8) == "abcd...");
  CHECK(one_line("ab\x1b"
                 "cdefgh",
                 8) == "ab...");  // not within an escape
  CHECK(in_quotes("a\nb") == "'a\\x0ab'");
}

TEST_CASE("Numbers for people have an exponent only where they are tiny or huge") {
  CHECK(significant(99.6, 2) == "100");
  CHECK(significant(123456.0, 3) == "123000");
  CHECK(significant(-999.96, 4) == "-1000");
  CHECK(significant(0.00012345, 2) == "0.00012");
  CHECK(significant(2.5e-7, 2) == "2.5e-07");
  CHECK(significant(9.99e14, 2) == "1e+15");
  CHECK(significant(2.7e34, 2) == "2.7e+34");
  CHECK(significant(std::numeric_limits<double>::infinity(), 3) == "inf");
  CHECK(duration_text(999.7) == "1000 ms");
  CHECK(bytes_text(999.9) == "1000 B");
  CHECK(bytes_text(1100.0) == "1.07 KiB");
  CHECK(bytes_text(0x1.8p41) == "3 TiB");
  CHECK(bytes_text(0x1.8p51) == "3072 TiB");  // the largest unit
}

TEST_CASE("A share is rounded down to a tenth of a percent") {
  CHECK(percent(0.8219) == "82.1%");
  CHECK(percent(0.9999) == "99.9%");
  CHECK(percent(1.0) == "100.0%");
  CHECK(percent(123.4567) == "12345.6%");
  CHECK(percent(0.0) == "0.0%");
  CHECK(percent(std::nan("")) == "nan%");
}

TEST_CASE("A path's extension is compared in lower case, letters beyond ASCII as they are") {
  CHECK(lower_extension("folder.EXR/picture.Png") == ".png");
  CHECK(lower_extension("A.TAR.GZ") == ".gz");
  CHECK(lower_extension("name.[Z@A]") == ".[z@a]");
  CHECK(lower_extension("name.\xc3\x84") == ".\xc3\x84");
  CHECK(lower_extension("name").empty());
}
