#include "widgets/document/autosaver.h"

#include "widgets/document/scenario_document.h"
#include "widgets/tasks/work_failure.h"
#include "widgets/words/error_text.h"

#include <QCoreApplication>
#include <QSysInfo>

namespace berg {

Autosaver::Autosaver(ScenarioDocument& document, QObject* parent)
    : QObject(parent), m_document(document)
{
    m_thread.setMaxThreadCount(1);
    for (QTimer* timer : {&m_pause, &m_longest}) {
        timer->setSingleShot(true);
        connect(timer, &QTimer::timeout, this, &Autosaver::write);
    }
}

Autosaver::~Autosaver()
{
    m_thread.waitForDone();
    if (m_recovery && !m_keep)
        removeRecovery(m_recovery->files);
}

void Autosaver::start(const QString& folder, const AutosaveTimes& times)
{
    m_store.emplace(folder);
    m_pause.setInterval(times.pause_ms);
    m_longest.setInterval(times.longest_ms);
    connect(&m_document, &ScenarioDocument::replaced, this, &Autosaver::drop);
    connect(&m_document, &ScenarioDocument::scenarioChanged, this, &Autosaver::follow);
    connect(&m_document, &ScenarioDocument::cleanChanged, this, &Autosaver::follow);
    follow();
}

FoundRecoveries Autosaver::abandoned() const
{
    return m_store ? m_store->abandoned() : FoundRecoveries();
}

void Autosaver::adopt(HeldRecovery recovery, std::shared_ptr<const RunFile> run)
{
    drop();
    m_thread.waitForDone(); // removal of the previous recovery
    m_recovery = std::move(recovery);
    m_run = std::move(run);
    follow();
}

void Autosaver::setRun(std::shared_ptr<const RunFile> run)
{
    if (!m_store || (m_run == nullptr && run == nullptr))
        return;
    m_run = std::move(run);
    follow();
}

bool Autosaver::hasNothing() const
{
    return m_document.isClean() && m_run == nullptr;
}

void Autosaver::keep()
{
    if (!m_store || hasNothing())
        return;
    write();
    m_thread.waitForDone();
    m_keep = true;
}

void Autosaver::discard()
{
    m_keep = false;
    m_run.reset();
    drop();
    m_thread.waitForDone();
}

void Autosaver::follow()
{
    if (hasNothing()) {
        drop();
        return;
    }
    m_pause.start();
    if (!m_longest.isActive())
        m_longest.start();
}

void Autosaver::drop()
{
    m_pause.stop();
    m_longest.stop();
    if (!m_recovery)
        return;
    m_thread.start([files = m_recovery->files] { removeRecovery(files); });
    emit dropped();
}

void Autosaver::write()
{
    m_pause.stop();
    m_longest.stop();
    try {
        if (!m_recovery)
            m_recovery = m_store->add();
    } catch (const Error& error) {
        emit failed(errorReport(error));
        return;
    }
    const RecoveryInfo info{.name = QString::fromStdString(m_document.scenario().name),
                            .originalPath = m_document.filePath(),
                            .edited = QDateTime::currentDateTime(),
                            .pid = QCoreApplication::applicationPid(),
                            .host = QSysInfo::machineHostName()};
    m_thread.start(
        [this, files = m_recovery->files, scenario = m_document.scenario(), info, run = m_run] {
            if (const auto failure =
                    failureOf([&] { writeRecovery(files, scenario, info, run.get()); }))
                emit failed(failure->report);
            else
                emit autosaved(info.edited);
        });
}

} // namespace berg
