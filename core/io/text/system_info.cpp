#include "core/io/text/system_info.h"

#include <fstream>
#include <sys/utsname.h>
#include <thread>

namespace berg {

namespace {

/** Processor name reported by the kernel; empty if it reports none, as on many ARM machines. */
std::string processorName()
{
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name"))
            if (const std::size_t first = line.find_first_not_of(" \t", line.find(':') + 1);
                first != std::string::npos)
                return line.substr(first);
    return {};
}

std::string systemName()
{
    utsname names{};
    if (::uname(&names) != 0)
        return {};
    return std::string(names.sysname) + ' ' + names.release + ' ' + names.machine;
}

} // namespace

std::string systemInfo()
{
    const unsigned cores = std::thread::hardware_concurrency();
    std::string text = processorName();
    if (cores > 0)
        text +=
            (text.empty() ? "" : ", ") + std::to_string(cores) + (cores == 1 ? " core" : " cores");
    if (const std::string system = systemName(); !system.empty())
        text += (text.empty() ? "" : ", ") + system;
    return text;
}

} // namespace berg
