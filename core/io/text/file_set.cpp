#include "core/io/text/file_set.h"

#include "core/base/error.h"
#include "core/io/text/atomic_file.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <vector>

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
        else if (std::filesystem::is_regular_file(path, ignored))
            std::filesystem::remove(path, ignored);
    } catch (const Error&) {
    }
}

/** Nothing can be taken back of what a pipe or a device was sent. */
bool canBePutBack(const NewFile& file)
{
    std::error_code none;
    return !isOpenDescriptor(file.path) && (!std::filesystem::exists(file.path, none) ||
                                            std::filesystem::is_regular_file(file.path, none));
}

} // namespace

void writeFileSet(std::span<const NewFile> files)
{
    std::vector<const NewFile*> order;
    for (const NewFile& file : files)
        order.push_back(&file);
    std::ranges::stable_partition(order, [](const NewFile* file) { return canBePutBack(*file); });

    std::vector<StagedFile> staged;
    std::vector<std::optional<std::string>> before;
    for (const NewFile* file : order) {
        staged.emplace_back(file->path, file->content);
        if (order.size() > 1)
            before.push_back(contentOf(file->path));
    }
    std::size_t placed = 0;
    try {
        if (staged.size() > 1)
            placed = StagedFile::placeTogether(staged);
        for (; placed < staged.size(); ++placed)
            staged[placed].place();
    } catch (...) {
        for (std::size_t i = 0; i < placed; ++i)
            putBack(order[i]->path, before[i]);
        throw;
    }
    for (const StagedFile& file : staged)
        file.makeLast();
}

} // namespace berg
