#pragma once

#include <QSettings>
#include <QTemporaryDir>

#include <array>
#include <optional>

namespace berg {

/** Sizes of text and window to choose from, in per cent of the system's. */
inline constexpr const char* kScaleKey = "view/scale";
inline constexpr std::array kScales_percent = {100, 125, 150, 175, 200};

/**
 * The settings of one run of the program, and where it keeps what belongs to them. GUI thread.
 *
 * A picture shows the program as it comes, or as the file says, and changes neither: its settings
 * are in a folder that goes with the run. So are those of a `config` that is there but is no
 * ordinary file, such as /dev/null: `QSettings` would put a file in its place.
 */
class RunSettings
{
public:
    /** `config` replaces the user's own settings file, unless it is empty. */
    RunSettings(const QString& config, bool isPicture);

    [[nodiscard]] QSettings& settings() { return *m_settings; }
    /**
     * Returns the size of text and window in that file, in per cent, or 100 if the file has none.
     * It is read before the application exists, because it decides its scale.
     */
    [[nodiscard]] static int savedScale_percent(const QString& config);

    /** Returns the folder of recovery files and locks. */
    [[nodiscard]] const QString& dataFolder() const { return m_dataFolder; }

private:
    std::optional<QTemporaryDir> m_folder; ///< outlives the settings, which write at their end
    std::optional<QSettings> m_settings;
    QString m_dataFolder;
};

} // namespace berg
