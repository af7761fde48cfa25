#pragma once

#include "widgets/theme/theme.h"

#include <vector>

namespace berg::test {

struct NamedTheme
{
    const char* name;
    Theme theme;
};

/** Returns the themes without high contrast, by name. */
inline const std::vector<NamedTheme>& themes()
{
    static const std::vector<NamedTheme> all = {
        {"light", Theme::light()}, {"dark", Theme::dark()}, {"night", Theme::night()}};
    return all;
}

} // namespace berg::test
