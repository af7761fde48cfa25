#include "widgets/aircraft/link_log.h"

#include "core/link/logs/telemetry_log.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>

using namespace Qt::StringLiterals;

namespace berg {

QString LinkLog::newPathIn(const QString& folder)
{
    const QDir dir(folder);
    const QString name = QDateTime::currentDateTime().toString(u"yyyy-MM-dd HHmmss"_s);
    QString path = dir.filePath(name + u".tlog"_s);
    for (int i = 2; QFileInfo::exists(path); ++i)
        path = dir.filePath(u"%1 (%2).tlog"_s.arg(name, QString::number(i)));
    return path;
}

void LinkLog::fail()
{
    m_report.fault = m_file.errorString().toStdString();
    m_file.close();
}

void LinkLog::add(LinkTime now, std::span<const std::uint8_t> frame)
{
    if (isEnded())
        return;
    if (!m_file.isOpen()) {
        const QFileInfo info(m_file.fileName());
        static_cast<void>(QDir().mkpath(info.path())); // opening reports the failure
        m_report.path = info.absoluteFilePath().toStdString();
        if (!m_file.open(QIODevice::WriteOnly | QIODevice::Append)) {
            fail();
            return;
        }
    }
    const std::vector<std::uint8_t> record = logRecord(now.unix_us, frame);
    if (m_report.bytes + record.size() > kLargest_bytes) {
        m_report.isFull = true;
        flush();
        m_file.close();
        return;
    }
    const auto size = static_cast<qint64>(record.size());
    if (m_file.write(reinterpret_cast<const char*>(record.data()), size) != size)
        fail();
    else
        m_report.bytes += record.size();
}

void LinkLog::flush()
{
    if (m_file.isOpen() && !m_file.flush())
        fail();
}

} // namespace berg
