#include "widgets/study/study_autosaver.h"

#include "core/io/study/study_json.h"
#include "widgets/tasks/work_failure.h"
#include "widgets/words/error_text.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

const QString kEnding = u".bergstudy"_s;

std::string studyPath(const RecoveryFiles& files)
{
    return QFile::encodeName(QDir(files.folder).filePath(files.id + kEnding)).toStdString();
}

} // namespace

StudyAutosaver::StudyAutosaver(StudyRunner& runner, QObject* parent)
    : QObject(parent), m_runner(runner)
{
    qRegisterMetaType<std::shared_ptr<const berg::Study>>();
    m_thread.setMaxThreadCount(1);
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &StudyAutosaver::write);
}

StudyAutosaver::~StudyAutosaver()
{
    m_thread.waitForDone();
    if (m_held && !m_keep && !m_isReading)
        removeRecovery(m_held->files);
}

void StudyAutosaver::start(const QString& folder, int interval_ms)
{
    m_folder = folder;
    m_timer.setInterval(interval_ms);
    connect(&m_runner, &StudyRunner::updated, this, &StudyAutosaver::follow);
    connect(&m_runner, &StudyRunner::finished, this, &StudyAutosaver::write);
}

void StudyAutosaver::follow()
{
    if (m_folder.isEmpty())
        return;
    if (m_runner.unsaved_s() <= 0)
        drop();
    else if (!m_timer.isActive())
        m_timer.start();
}

void StudyAutosaver::write()
{
    m_timer.stop();
    if (m_runner.unsaved_s() <= 0 || !m_runner.result())
        return;
    if (m_isReading || m_thread.activeThreadCount() > 0) { // a large study takes long to write
        m_timer.start();
        return;
    }
    try {
        if (!m_held)
            m_held = RecoveryStore(m_folder).add();
    } catch (const Error& error) {
        emit failed(errorReport(error));
        return;
    }
    m_thread.start([this, files = m_held->files, result = m_runner.result()] {
        if (const auto failure = failureOf([&] { saveStudy(result->study, studyPath(files)); }))
            emit failed(failure->report);
    });
}

void StudyAutosaver::drop()
{
    m_timer.stop();
    if (m_held && !m_isReading)
        m_thread.start([files = m_held->files] { removeRecovery(files); });
}

void StudyAutosaver::keep()
{
    if (m_folder.isEmpty())
        return;
    m_thread.waitForDone();
    write();
    m_thread.waitForDone();
    m_keep = m_runner.unsaved_s() > 0;
}

void StudyAutosaver::discard()
{
    m_keep = false;
    drop();
    m_thread.waitForDone();
}

void StudyAutosaver::findAbandoned()
{
    if (m_folder.isEmpty() || m_held)
        return;
    removeEmptyRecoveries(m_folder, kEnding);
    for (const QFileInfo& file :
         QDir(m_folder).entryInfoList({u'*' + kEnding}, QDir::Files, QDir::Time)) {
        HeldRecovery held{.files = {.folder = m_folder, .id = file.completeBaseName()}, .lock = {}};
        if (held.lock.take(held.files.lock()) == FileLock::Outcome::Taken) {
            m_held = std::move(held);
            read();
            return; // further recoveries follow at the next start
        }
    }
}

void StudyAutosaver::read()
{
    m_isReading = true;
    m_thread.start([this, path = studyPath(m_held->files)] {
        std::shared_ptr<const Study> study;
        const std::optional<WorkFailure> why =
            failureOf([&] { study = std::make_shared<const Study>(loadStudy(path)); });
        if (why && why->isExpected) { // kept so that it can be examined
            const QString name = QFile::decodeName(QByteArray::fromStdString(path));
            const QString aside = name + u".damaged"_s;
            emit damaged(QFile::rename(name, aside) ? aside : name);
        }
        const QString failure = why && !why->isExpected ? why->report : QString();
        QMetaObject::invokeMethod(
            this, [this, study, failure] { accept(study, failure); }, Qt::QueuedConnection);
    });
}

void StudyAutosaver::accept(const std::shared_ptr<const Study>& study, const QString& failure)
{
    m_isReading = false;
    if (study && m_runner.unsaved_s() <= 0) {
        emit found(study);
        return;
    }
    m_held.reset(); // another study is flown by now: the recovery stays for the next start
    if (!failure.isEmpty())
        emit failed(failure);
}

} // namespace berg
