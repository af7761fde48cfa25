#pragma once

#include "core/mission/mission.h"

#include <QLocale>
#include <QSize>
#include <QString>
#include <QStringList>

#include <optional>

namespace berg {

/** Appearance of pictures. */
enum class PictureTheme
{
    Light,
    Dark,
    Both
};

struct PictureOptions
{
    QString folder;
    std::optional<QSize>
        size_px; ///< size of every picture; by default maps 1600 x 1000, charts 1600 x 700
    PictureTheme theme = PictureTheme::Light;
};

/** Smallest and largest side of a picture, pixels. */
inline constexpr int kSmallestPicture_px = 100;
inline constexpr int kLargestPicture_px = 8192;

/**
 * Flies the mission of a scenario to its end, or replays a run as far as it was flown. Throws
 * `Error` if the file is neither, is invalid or cannot be read, and `ReplayMismatch` if the replay
 * differs from the record.
 */
[[nodiscard]] Mission flownMission(const std::string& path);

/** Returns the names of the files that `writePictures` writes. */
[[nodiscard]] QStringList pictureNames(PictureTheme theme);

/**
 * Writes map.png, zeta.png and sigma.png (with `-dark` appended for the dark appearance if both are
 * requested), all or none, into the folder, which is created if missing. Returns the paths written.
 * Throws `Error{FileUnwritable}`. Needs a QApplication.
 */
QStringList writePictures(const Mission& mission, const PictureOptions& options,
                          const QLocale& locale);

} // namespace berg
