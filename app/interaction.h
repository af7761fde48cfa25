#pragma once

#include <QString>

#include <optional>

class QWidget;

namespace berg {

/** What can be exported, and what to suggest. */
struct ExportOffer
{
    QString path;       ///< suggested file
    QString formatId;   ///< chosen at first; unknown: the first of the table
    bool flown = false; ///< what was flown is exported, not the plan from the start
};

/** What the user wants exported. */
struct ExportChoice
{
    QString formatId; ///< of `exportFormats`
    QString path;
};

/** Everything modal the window asks of a person, behind one interface so that tests can answer. */
class Interaction
{
public:
    enum class Unsaved
    {
        Save,
        Discard,
        Cancel
    };

    Interaction() = default;
    Interaction(const Interaction&) = delete;
    Interaction& operator=(const Interaction&) = delete;
    virtual ~Interaction() = default;

    /** The scenario has changes that are in no file. */
    [[nodiscard]] virtual Unsaved askUnsaved(QWidget* parent, const QString& name) = 0;
    /** Empty: cancelled. `filter` as in `QFileDialog`. */
    [[nodiscard]] virtual QString openPath(QWidget* parent, const QString& filter) = 0;
    [[nodiscard]] virtual QString savePath(QWidget* parent, const QString& suggested,
                                           const QString& filter) = 0;
    /** None: cancelled. */
    [[nodiscard]] virtual std::optional<ExportChoice> chooseExport(QWidget* parent,
                                                                   const ExportOffer& offer) = 0;
    virtual void showError(QWidget* parent, const QString& text) = 0;
    virtual void showInformation(QWidget* parent, const QString& title, const QString& html) = 0;
};

/** The real one: Qt's dialogs. */
class DialogInteraction final : public Interaction
{
public:
    [[nodiscard]] Unsaved askUnsaved(QWidget* parent, const QString& name) override;
    [[nodiscard]] QString openPath(QWidget* parent, const QString& filter) override;
    [[nodiscard]] QString savePath(QWidget* parent, const QString& suggested,
                                   const QString& filter) override;
    [[nodiscard]] std::optional<ExportChoice> chooseExport(QWidget* parent,
                                                           const ExportOffer& offer) override;
    void showError(QWidget* parent, const QString& text) override;
    void showInformation(QWidget* parent, const QString& title, const QString& html) override;
};

} // namespace berg
