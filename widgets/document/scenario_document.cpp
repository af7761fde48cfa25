#include "widgets/document/scenario_document.h"

#include "core/checks/validate.h"
#include "core/io/files/scenario_json.h"
#include "core/io/text/atomic_file.h"

#include <QCryptographicHash>
#include <QFile>
#include <QScopedValueRollback>
#include <QUndoCommand>
#include <QUndoStack>

#include <memory>
#include <utility>

namespace berg {

QByteArray hashOf(const std::string& content)
{
    return QCryptographicHash::hash(QByteArrayView(content.data(), std::ssize(content)),
                                    QCryptographicHash::Sha256);
}

/**
 * The only undo command: the scenario before and after. A scenario of 500 icebergs takes 130
 * kilobytes, so successive commands share the one between them.
 */
class EditScenario final : public QUndoCommand
{
public:
    EditScenario(ScenarioDocument& document, const QString& text, Scenario after, QString gesture)
        : QUndoCommand(text)
        , m_document(document)
        , m_before(present(document))
        , m_after(std::make_shared<const Scenario>(std::move(after)))
        , m_gesture(std::move(gesture))
    {
    }

    void undo() override { m_document.stepTo(*m_before); }
    void redo() override
    {
        if (std::exchange(m_isPushed, true))
            m_document.stepTo(*m_after);
        else
            m_document.setScenario(*m_after);
    }
    [[nodiscard]] int id() const override { return m_gesture.isEmpty() ? -1 : 1; }

    bool mergeWith(const QUndoCommand* other) override
    {
        const auto* next = dynamic_cast<const EditScenario*>(other);
        if (next == nullptr || next->m_gesture != m_gesture)
            return false;
        m_after = next->m_after;
        setObsolete(*m_after == *m_before);
        return true;
    }

private:
    static std::shared_ptr<const Scenario> present(const ScenarioDocument& document)
    {
        const QUndoStack& history = *document.undoStack();
        const auto* last = dynamic_cast<const EditScenario*>(history.command(history.index() - 1));
        return last != nullptr ? last->m_after
                               : std::make_shared<const Scenario>(document.scenario());
    }

    ScenarioDocument& m_document;
    std::shared_ptr<const Scenario> m_before;
    std::shared_ptr<const Scenario> m_after;
    QString m_gesture;
    bool m_isPushed = false;
};

ScenarioDocument::ScenarioDocument(QObject* parent)
    : QObject(parent), m_undoStack(new QUndoStack(this))
{
    m_undoStack->setUndoLimit(1000);
    connect(m_undoStack, &QUndoStack::cleanChanged, this, &ScenarioDocument::cleanChanged);
}

ScenarioDocument::~ScenarioDocument()
{
    // The stack is a child and would emit signals while this object is being destroyed.
    m_undoStack->disconnect(this);
}

bool ScenarioDocument::isClean() const
{
    return m_undoStack->isClean();
}

bool ScenarioDocument::edit(const QString& text, const std::function<void(Scenario&)>& change,
                            const QString& gesture)
{
    if (m_isStepping) // a listener of the step must not add another one to it
        return false;
    Scenario after = m_scenario;
    change(after);
    if (after == m_scenario || refuses())
        return false;
    if (const std::vector<Issue> issues = unreadable(after);
        !issues.empty() && unreadable(m_scenario).empty()) {
        emit editRejected(issues.front());
        return false;
    }
    const QString key =
        gesture.isEmpty() ? QString() : gesture + u'#' + QString::number(m_gestureNumber);
    m_undoStack->push(new EditScenario(*this, text, std::move(after), key));
    return true;
}

void ScenarioDocument::setNewIcebergSource(SightingSource source)
{
    if (std::exchange(m_newIcebergSource, source) != source)
        emit newIcebergSourceChanged(source);
}

Iceberg ScenarioDocument::newIceberg() const
{
    Iceberg iceberg;
    iceberg.sigma0_m2 = errorOf(m_newIcebergSource).sigma_m2();
    return iceberg;
}

void ScenarioDocument::endGesture()
{
    ++m_gestureNumber;
}

void ScenarioDocument::follow(const QString& key, const std::function<void(Scenario&)>& change)
{
    if (m_isStepping || m_isLocked)
        return;
    m_followed[key] = change;
    stepTo(m_scenario);
}

/** Changes that are followed apply to every step of the history. */
void ScenarioDocument::stepTo(const Scenario& scenario)
{
    Scenario after = scenario;
    for (const auto& change : std::as_const(m_followed))
        change(after);
    if (after != scenario) {
        if (!unreadable(after).empty() && unreadable(scenario).empty())
            after = scenario;
        else
            m_undoStack->resetClean(); // the file does not have this change
    }
    setScenario(after);
}

void ScenarioDocument::undo()
{
    const QScopedValueRollback stepping(m_isStepping, true);
    if (!refuses())
        m_undoStack->undo();
}

void ScenarioDocument::redo()
{
    const QScopedValueRollback stepping(m_isStepping, true);
    if (!refuses())
        m_undoStack->redo();
}

bool ScenarioDocument::refuses()
{
    if (m_isLocked)
        emit refused();
    return m_isLocked;
}

void ScenarioDocument::setScenario(const Scenario& scenario)
{
    const bool isNew = scenario != m_scenario;
    m_scenario = scenario;
    m_issues = validate(m_scenario);
    if (isNew)
        emit scenarioChanged();
}

void ScenarioDocument::begin(const Scenario& scenario, const QString& filePath, bool clean,
                             const QByteArray& fileHash)
{
    m_isLocked = false;
    m_followed.clear();
    m_undoStack->clear();
    m_filePath = filePath;
    m_fileHash = fileHash;
    m_scenario = scenario;
    m_issues = validate(m_scenario);
    emit replaced();
    if (!clean)
        m_undoStack->resetClean(); // no number of undos leads back to the content of the file
    emit filePathChanged(m_filePath);
    emit scenarioChanged();
}

void ScenarioDocument::reset(const Scenario& scenario)
{
    begin(scenario, {}, true);
}

void ScenarioDocument::restore(const Scenario& scenario, const QString& filePath)
{
    begin(scenario, filePath, false);
}

void ScenarioDocument::open(const QString& path)
{
    const std::string name = QFile::encodeName(path).toStdString();
    const std::string content = readFile(name);
    begin(scenarioFromJson(content, name, ScenarioUse::Editing), path, true, hashOf(content));
}

void ScenarioDocument::save(const QString& path)
{
    const std::string content = scenarioToJson(m_scenario);
    writeFileAtomically(QFile::encodeName(path).toStdString(), content);
    m_filePath = path;
    m_fileHash = hashOf(content);
    m_undoStack->setClean();
    emit filePathChanged(m_filePath);
}

} // namespace berg
