#pragma once

#include "app/interaction.h"

#include <QStringList>

namespace berg::test {

/** Answers what the window asks as the test has set, and keeps what was asked. */
class FakeInteraction final : public Interaction
{
public:
    Unsaved unsaved = Unsaved::Cancel;
    QString path; ///< of the next file; empty: cancelled
    std::optional<ExportChoice> exportChoice;

    QStringList unsavedNames; ///< each question about unsaved changes
    QStringList suggested;    ///< each question where to save
    int openQuestions = 0;
    QStringList errors;
    QStringList informations;
    std::vector<ExportOffer> offers;

    [[nodiscard]] Unsaved askUnsaved(QWidget*, const QString& name) override
    {
        unsavedNames << name;
        return unsaved;
    }
    [[nodiscard]] QString openPath(QWidget*, const QString&) override
    {
        ++openQuestions;
        return path;
    }
    [[nodiscard]] QString savePath(QWidget*, const QString& suggestion, const QString&) override
    {
        suggested << suggestion;
        return path;
    }
    [[nodiscard]] std::optional<ExportChoice> chooseExport(QWidget*,
                                                           const ExportOffer& offer) override
    {
        offers.push_back(offer);
        return exportChoice;
    }
    void showError(QWidget*, const QString& text) override { errors << text; }
    void showInformation(QWidget*, const QString& title, const QString& html) override
    {
        informations << title + QLatin1Char('\n') + html;
    }
};

} // namespace berg::test
