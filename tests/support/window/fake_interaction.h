#pragma once

#include "app/dialogs/interaction.h"

#include <QStringList>
#include <QTest>

#include <functional>

namespace berg::test {

/** Answers questions of the window as set by the test, and records them. */
class FakeInteraction final : public Interaction
{
public:
    Unsaved unsaved = Unsaved::Cancel;
    std::vector<Unsaved> unsavedAnswers; ///< used in turn, then `unsaved`
    Unsaved unsavedRun = Unsaved::Cancel;
    QString path; ///< path of the next file; empty to cancel
    InUse inUse = InUse::Cancel;
    Overwrite overwrite = Overwrite::Cancel;
    bool reload = false;
    bool endsFlight = false;
    bool removes = true;
    bool undoes = true;
    /** Changes and their times, in questions about undoing them in flight. */
    QStringList undoQuestions;
    QStringList removals; ///< names in questions about removing icebergs in flight
    std::vector<RecoveryAnswer> recoveryAnswers; ///< used in turn, then Later
    std::optional<ExportRequest> exportChoice;
    std::function<void()> whileExportIsChosen; ///< called while the dialog is open
    std::function<void()> whileOverwriteIsAsked;
    std::optional<OriginChoice> originChoice;
    std::optional<Point> wind_mps;         ///< answer
    std::optional<double> declination_deg; ///< answer
    int sounds = 0;                        ///< number of alarm sounds
    /** Answers a question about an import; null cancels. */
    std::function<std::optional<ImportChoice>(ImportRunner&, const ImportOffer&)> importAnswer;

    QStringList unsavedNames; ///< one for each question about unsaved changes
    QStringList suggested;    ///< one for each question about a file name
    /** One for each question about an unsaved run: whether it is in progress. */
    std::vector<bool> runQuestions;
    int openQuestions = 0;
    bool mentionedFlight = false; ///< whether the last of them mentioned the flight
    int endFlightQuestions = 0;
    std::optional<FlightEnd> flightEnd; ///< flight end of the last of them
    QStringList holders;                ///< one for each question about a file in use
    QStringList overwriteReasons;       ///< one for each question about overwriting a file
    QStringList reloadQuestions;
    std::vector<std::vector<RecoveryOffer>> recoveryOffers;
    QStringList waits;                  ///< titles of waits while the window existed
    std::vector<bool> mayCancelWaits;   ///< whether each of them could be cancelled
    std::function<void()> whileWaiting; ///< called before the end is checked
    QStringList errors;
    QStringList informations;
    std::vector<ExportOffer> offers;
    std::vector<LatLon> suggestedOrigins;
    std::vector<ForecastOffer> forecastOffers;
    std::optional<ForecastChoice> forecastChoice; ///< answer to the question about the forecast
    std::vector<Point> askedWinds_mps;            ///< wind at each question about the wind
    std::vector<ImportOffer> importOffers;

    [[nodiscard]] Unsaved askUnsaved(QWidget*, const UnsavedWork& work) override
    {
        unsavedNames << work.name;
        mentionedFlight = work.endsFlight;
        passTime();
        const auto asked = static_cast<std::size_t>(unsavedNames.size());
        return asked <= unsavedAnswers.size() ? unsavedAnswers[asked - 1] : unsaved;
    }
    [[nodiscard]] Unsaved askUnsavedRun(QWidget*, bool isUnderWay) override
    {
        runQuestions.push_back(isUnderWay);
        return unsavedRun;
    }
    [[nodiscard]] bool askEndFlight(QWidget*, FlightEnd why) override
    {
        ++endFlightQuestions;
        flightEnd = why;
        return endsFlight;
    }
    /** Called while a question about an import, a file or the wind is open. */
    std::function<void()> meanwhile;
    [[nodiscard]] bool askRemove(QWidget*, const QStringList& names) override
    {
        removals << names;
        passTime();
        return removes;
    }
    [[nodiscard]] bool askUndo(QWidget*, const QString& change, const QString& since) override
    {
        undoQuestions << change + QStringLiteral(" | ") + since;
        passTime();
        return undoes;
    }
    [[nodiscard]] QString openPath(QWidget*, const QString&) override
    {
        ++openQuestions;
        passTime();
        return path;
    }
    [[nodiscard]] QString savePath(QWidget*, const QString& suggestion, const QString&) override
    {
        suggested << suggestion;
        return path;
    }
    [[nodiscard]] std::optional<ExportRequest> chooseExport(QWidget*, MissionRunner&,
                                                            const ExportOffer& offer) override
    {
        offers.push_back(offer);
        if (whileExportIsChosen)
            whileExportIsChosen();
        return exportChoice;
    }
    [[nodiscard]] std::optional<ImportChoice> chooseImport(QWidget*, ImportRunner& runner,
                                                           const ImportOffer& offer) override
    {
        importOffers.push_back(offer);
        passTime();
        return importAnswer ? importAnswer(runner, offer) : std::nullopt;
    }
    [[nodiscard]] std::optional<OriginChoice> askOrigin(QWidget*, const Scenario&,
                                                        const LatLon& place, const Theme&) override
    {
        suggestedOrigins.push_back(place);
        passTime();
        return originChoice;
    }
    [[nodiscard]] std::optional<ForecastChoice> askForecast(QWidget*,
                                                            const ForecastOffer& offer) override
    {
        forecastOffers.push_back(offer);
        passTime();
        return forecastChoice;
    }
    [[nodiscard]] std::optional<Point> askWind(QWidget*, const Point& present_mps, double) override
    {
        askedWinds_mps.push_back(present_mps);
        passTime();
        return wind_mps;
    }
    void soundAlarm() override { ++sounds; }
    [[nodiscard]] std::optional<double> askDeclination(QWidget*, double) override
    {
        passTime();
        return declination_deg;
    }
    [[nodiscard]] InUse askInUse(QWidget*, const QString&, const QString& holder) override
    {
        holders << holder;
        return inUse;
    }
    [[nodiscard]] Overwrite askOverwrite(QWidget*, const QString&, const QString& reason) override
    {
        overwriteReasons << reason;
        if (whileOverwriteIsAsked)
            whileOverwriteIsAsked();
        return overwrite;
    }
    [[nodiscard]] bool askReload(QWidget*, const QString& fileName) override
    {
        reloadQuestions << fileName;
        return reload;
    }
    [[nodiscard]] RecoveryAnswer askRecovery(QWidget*,
                                             const std::vector<RecoveryOffer>& offered) override
    {
        recoveryOffers.push_back(offered);
        const std::size_t asked = recoveryOffers.size();
        return asked <= recoveryAnswers.size() ? recoveryAnswers[asked - 1] : RecoveryAnswer{};
    }
    void waitUntil(QWidget*, const QString& text, const std::function<bool()>& isDone,
                   bool mayCancel) override
    {
        waits << text;
        mayCancelWaits.push_back(mayCancel);
        if (whileWaiting)
            whileWaiting();
        constexpr int kLongest_ms = 60'000;
        static_cast<void>(QTest::qWaitFor(isDone, kLongest_ms));
    }
    void showError(QWidget*, const QString& text) override { errors << text; }
    void showInformation(QWidget*, const QString& title, const QString& html) override
    {
        informations << title + QLatin1Char('\n') + html;
    }

private:
    void passTime() const
    {
        if (meanwhile)
            meanwhile();
    }
};

} // namespace berg::test
