#include "core/io/export_writing.h"

#include "core/io/atomic_file.h"

#include <filesystem>
#include <optional>

namespace berg {

namespace {

/** What is there; none: nothing that could be lost. */
std::optional<std::string> contentOf(const std::string& path)
{
    std::error_code none;
    return std::filesystem::is_regular_file(path, none) ? std::optional(readFile(path))
                                                        : std::nullopt;
}

void putBack(const std::string& path, const std::optional<std::string>& content)
{
    std::error_code ignored; // the first fault is the one to be told
    try {
        if (content)
            writeFileAtomically(path, *content);
        else
            std::filesystem::remove(path, ignored);
    } catch (const Error&) {
    }
}

} // namespace

void writeExport(std::span<const ExportFile> files)
{
    std::vector<std::optional<std::string>> before;
    if (files.size() > 1)
        for (const ExportFile& file : files)
            before.push_back(contentOf(file.path));
    std::size_t written = 0;
    try {
        for (; written < files.size(); ++written)
            writeFileAtomically(files[written].path, files[written].content);
    } catch (...) {
        for (std::size_t i = 0; i < written; ++i)
            putBack(files[i].path, before[i]);
        throw;
    }
}

} // namespace berg
