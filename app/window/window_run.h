#pragma once

#include <QSize>
#include <QString>

#include <optional>

namespace berg {

/** How the window is opened. */
struct WindowOptions
{
    QString scenario;             ///< file to open; empty: the default scenario
    QString config;               ///< settings file in place of the user's own
    QString screenshot;           ///< file to render the window into, then end; empty: stay open
    std::optional<QSize> size_px; ///< none: as it was left, at first what fits the screen
    std::optional<bool> dark;     ///< none: as the user chose
    double at_s = 0;              ///< flown until then before the screenshot
    double wait_s = 0;            ///< at most, before it, for predictions and bound
};

inline constexpr int kLongestScreenshotWait_s = 3600;

/** Runs the window until it is closed; the exit code of the program. */
int runWindow(const WindowOptions& options);

} // namespace berg
