#pragma once

namespace berg {

/** Registers a test with its program under the name of its file, without `.cpp`. */
bool enlistTest(const char* file, int (*run)(int argc, char** argv));

} // namespace berg
