#include "core/base/version.h"

namespace berg {

std::string programVersion()
{
    return BERGWATCH_VERSION;
}

std::string programName()
{
    return "Bergwatch " + programVersion();
}

} // namespace berg
