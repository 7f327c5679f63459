// Catch2 version 2 makes its main here, compiled once.
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
