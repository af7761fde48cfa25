#pragma once

#include "core/base/error.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace berg::test {

/** Returns the `Error` that an action throws, or nullopt; other exceptions pass. */
template <class Action>
std::optional<Error> errorOf(Action&& action)
{
    try {
        std::forward<Action>(action)();
    } catch (const Error& error) {
        return error;
    }
    return std::nullopt;
}

inline std::string codeName(ErrorCode code)
{
    switch (code) {
    case ErrorCode::FileNotFound:
        return "FileNotFound";
    case ErrorCode::FileUnreadable:
        return "FileUnreadable";
    case ErrorCode::FileUnwritable:
        return "FileUnwritable";
    case ErrorCode::FileTooLarge:
        return "FileTooLarge";
    case ErrorCode::SyntaxError:
        return "SyntaxError";
    case ErrorCode::WrongFormat:
        return "WrongFormat";
    case ErrorCode::UnsupportedVersion:
        return "UnsupportedVersion";
    case ErrorCode::InvalidInput:
        return "InvalidInput";
    case ErrorCode::Unsupported:
        return "Unsupported";
    case ErrorCode::SolverFailed:
        return "SolverFailed";
    case ErrorCode::ReplayMismatch:
        return "ReplayMismatch";
    }
    return "unknown";
}

/** Returns the code name of the `Error` that an action throws, or "nothing". */
template <class Action>
std::string codeOf(Action&& action)
{
    const std::optional<Error> error = errorOf(std::forward<Action>(action));
    return error ? codeName(error->code()) : "nothing";
}

/** Returns whether a finding names exactly this field. */
inline bool names(const std::vector<Issue>& issues, const std::string& field)
{
    return std::any_of(issues.begin(), issues.end(),
                       [&](const Issue& issue) { return issue.field == field; });
}

} // namespace berg::test
