#include "widgets/study/study_files.h"

#include "core/base/version.h"
#include "core/io/results/result_json.h"
#include "core/io/study/study_json.h"
#include "core/io/study/study_report.h"
#include "core/io/text/atomic_file.h"
#include "core/io/text/system_info.h"
#include "widgets/tasks/work_failure.h"
#include "widgets/words/report_language.h"

#include <QDateTime>
#include <QFile>

using namespace Qt::StringLiterals;

namespace berg {
StudyFiles::StudyFiles(QObject* parent) : QObject(parent), m_thread(u"study files"_s) {}

StudyFiles::~StudyFiles()
{
    m_thread.finish();
}

void StudyFiles::post(const std::function<Notification()>& job)
{
    m_thread.post([this, job] {
        Notification notify;
        if (const auto failure = failureOf([&] { notify = job(); }))
            notify = [this, report = failure->report] { emit failed(report); };
        // The notification starts on this object: a queued signal from another thread would be lost
        // when the window is recreated.
        QMetaObject::invokeMethod(this, notify, Qt::QueuedConnection);
    });
}

void StudyFiles::write(const QString& path, const std::function<std::string()>& content)
{
    post([this, path, content]() -> Notification {
        writeFileAtomically(QFile::encodeName(path).toStdString(), content());
        return [this, path] { emit written(path); };
    });
}

void StudyFiles::open(const QString& path)
{
    post([this, path]() -> Notification {
        const auto study =
            std::make_shared<const Study>(loadStudy(QFile::encodeName(path).toStdString()));
        return [this, study] { emit opened(study); };
    });
}

void StudyFiles::save(const StudyPointer& result, const StudySavePoint& point, const QString& path)
{
    post([this, result, point, path]() -> Notification {
        saveStudy(result->study, QFile::encodeName(path).toStdString());
        return [this, path, point] { emit saved(path, point); };
    });
}

void StudyFiles::writeReport(const StudyPointer& result, std::optional<double> elapsed_s,
                             const QString& path)
{
    const std::string now = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
    write(path, [result, elapsed_s, now] {
        return studyReportHtml(result->study, result->summary,
                               {.program = programName(),
                                .machine = systemInfo(),
                                .madeUtc = now,
                                .elapsed_s = elapsed_s,
                                .words = reportLanguage()});
    });
}

void StudyFiles::writeTable(const StudyPointer& result, const QString& path)
{
    write(path, [result] { return sweepCsv(result->summary); });
}

} // namespace berg
