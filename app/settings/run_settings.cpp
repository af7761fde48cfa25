#include "app/settings/run_settings.h"

#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {

RunSettings::RunSettings(const QString& config, bool isPicture)
{
    const QFileInfo file(config);
    const bool isSpecial = file.exists() && !file.isFile(); // what links lead to
    if (isPicture || isSpecial) {
        m_folder.emplace();
        const QString copy = m_folder->filePath(u"settings.ini"_s);
        if (file.isFile())
            QFile::copy(config, copy);
        m_settings.emplace(copy, QSettings::IniFormat);
        m_dataFolder = m_folder->filePath(u"data"_s);
    } else if (config.isEmpty()) {
        m_settings.emplace(u"Bergwatch"_s, u"bergwatch"_s);
        m_dataFolder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    } else {
        m_settings.emplace(config, QSettings::IniFormat);
        m_dataFolder = config + u".data"_s;
    }
}

int RunSettings::savedScale_percent(const QString& config)
{
    RunSettings run(config, false);
    const int scale = run.settings().value(kScaleKey, 100).toInt();
    return std::clamp(scale, kScales_percent.front(), kScales_percent.back());
}

} // namespace berg
