#pragma once

namespace berg {

/** Puts a test on the list of its program under the name of its file, without `.cpp`. */
bool enlistTest(const char* file, int (*run)(int argc, char** argv));

} // namespace berg
