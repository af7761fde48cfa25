#pragma once

#include "tests/support/flight/scenario_builder.h"
#include "widgets/map/picture/scenario_picture.h"
#include "widgets/map/view/map_view.h"

#include <QUndoStack>
#include <QtTest>

namespace berg::test {

/**
 * A visible map of 1000 x 700 pixels with four icebergs far apart, and its document. Unless the map
 * is locked, it shows the scenario after each edit.
 */
struct MapFixture
{
    ScenarioDocument document;
    Selection selection;
    MapView view{document, selection};

    MapFixture()
    {
        QObject::connect(&document, &ScenarioDocument::scenarioChanged, &view, [this] {
            if (!view.isLocked())
                showScenario();
        });
        document.reset(fourIcebergs());
        view.resize(1000, 700);
        view.show();
        showScenario();
    }

    /** Shows the scenario as it is now. */
    void showScenario() { view.setPicture(withScenario(plainPicture(), scenario())); }

    /** berg-1 to berg-4 in a square of 2 km, the UAV at the origin. */
    [[nodiscard]] static Scenario fourIcebergs()
    {
        Scenario scenario = emptySea();
        addIceberg(scenario, 1500, 1000);
        addIceberg(scenario, 3500, 1000);
        addIceberg(scenario, 1500, 3000).velocity_mps = {0.2, 0.1};
        addIceberg(scenario, 3500, 3000).velocity_mps = {-0.1, 0.3};
        return scenario;
    }
    /** Returns the scenario with a short duration. */
    static Scenario shortRun()
    {
        Scenario scenario = fourIcebergs();
        scenario.duration_s = 200;
        return scenario;
    }

    /** Returns the picture of the scenario without the title panel. */
    [[nodiscard]] static MapPicture plainPicture()
    {
        MapPicture picture;
        picture.sigmaFull_m2 = 10;
        return picture;
    }

    [[nodiscard]] const Scenario& scenario() const { return document.scenario(); }
    [[nodiscard]] int undoCount() const { return document.undoStack()->count(); }
    [[nodiscard]] int undoIndex() const { return document.undoStack()->index(); }

    [[nodiscard]] QPoint pixelOf(const Point& p_m) const { return view.toScreen(p_m).toPoint(); }
    [[nodiscard]] QPoint iceberg(std::size_t i) const
    {
        return pixelOf(scenario().icebergs[i].position_m);
    }
    [[nodiscard]] QPoint uav() const { return pixelOf(scenario().uavs.front().position_m); }

    void press(const QPoint& at, Qt::KeyboardModifiers keys = {})
    {
        QTest::mousePress(&view, Qt::LeftButton, keys, at);
    }
    void move(const QPoint& to) { QTest::mouseMove(&view, to); }
    void release(const QPoint& at, Qt::KeyboardModifiers keys = {})
    {
        QTest::mouseRelease(&view, Qt::LeftButton, keys, at);
    }
    void click(const QPoint& at, Qt::KeyboardModifiers keys = {})
    {
        QTest::mouseClick(&view, Qt::LeftButton, keys, at);
    }
    /** Presses, moves twice, and releases if `letGo`. */
    void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers keys = {},
              bool letGo = true)
    {
        press(from, keys);
        move((from + to) / 2);
        move(to);
        if (letGo)
            release(to, keys);
    }
};

} // namespace berg::test
