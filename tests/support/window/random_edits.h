#pragma once

#include "core/base/random.h"
#include "tests/support/window/map_fixture.h"
#include "widgets/map/view/map_handles.h"

#include <QSet>

#include <array>

namespace berg::test {

/** Edits a scenario on the map in every possible manner, with mouse and keys. */
class RandomEdits
{
public:
    RandomEdits(MapFixture& map, std::uint64_t seed) : m_map(map), m_random(seed, 17) {}

    /** Makes or attempts one edit; returns its name. */
    QString edit()
    {
        struct EditKind
        {
            const char* name;
            void (RandomEdits::*act)();
        };
        static constexpr std::array kKinds{EditKind{"place", &RandomEdits::place},
                                           EditKind{"move", &RandomEdits::move},
                                           EditKind{"drag drift", &RandomEdits::dragDrift},
                                           EditKind{"nudge", &RandomEdits::nudge},
                                           EditKind{"paste", &RandomEdits::paste},
                                           EditKind{"duplicate", &RandomEdits::duplicate},
                                           EditKind{"delete", &RandomEdits::remove},
                                           EditKind{"draw area", &RandomEdits::drawArea},
                                           EditKind{"move corner", &RandomEdits::moveCorner},
                                           EditKind{"tau", &RandomEdits::slideTau},
                                           EditKind{"settings", &RandomEdits::change},
                                           EditKind{"table", &RandomEdits::changeMany},
                                           EditKind{"asset", &RandomEdits::placeAsset},
                                           EditKind{"place UAV", &RandomEdits::placeUav},
                                           EditKind{"type", &RandomEdits::type},
                                           EditKind{"take back", &RandomEdits::takeBack}};
        const EditKind& kind = kKinds[m_random.below(kKinds.size())];
        const Scenario before = m_map.scenario();
        (this->*kind.act)();
        const QString name = QString::fromLatin1(kind.name);
        m_all.insert(name);
        if (!(m_map.scenario() == before))
            m_changed.insert(name);
        return name;
    }

    /** Returns the names of edits that never changed anything, except those that should not. */
    [[nodiscard]] QStringList kindsMissing() const
    {
        QSet<QString> missing = m_all - m_changed;
        missing.remove(QStringLiteral("take back"));
        return missing.values();
    }

private:
    static constexpr std::size_t kMostIcebergs = 12; // more only take time

    [[nodiscard]] QPoint anywhere()
    {
        return {60 + static_cast<int>(m_random.below(880)),
                60 + static_cast<int>(m_random.below(580))};
    }
    [[nodiscard]] std::string anyIceberg()
    {
        const std::vector<Iceberg>& icebergs = m_map.scenario().icebergs;
        return icebergs.empty() ? std::string("uav-1")
                                : icebergs[m_random.below(icebergs.size())].id;
    }
    void select()
    {
        std::vector<std::string> ids{anyIceberg()};
        if (m_random.below(2) == 0)
            ids.push_back(anyIceberg());
        const std::array<std::string, 4> others{"", "uav-1", kAssetKey, kAreaKey};
        if (const std::string& other = others[m_random.below(others.size())]; !other.empty())
            ids.push_back(other);
        m_map.selection.set(ids);
        m_map.selection.keepExisting(m_map.scenario());
    }
    void take(MapToolKind tool) { m_map.view.tools().setKind(tool); }
    void key(Qt::Key which, Qt::KeyboardModifiers keys = {})
    {
        QTest::keyClick(&m_map.view, which, keys);
    }

    void place()
    {
        take(MapToolKind::Iceberg);
        if (m_map.scenario().icebergs.size() >= kMostIcebergs)
            return;
        if (m_random.below(2) == 0)
            m_map.click(anywhere());
        else
            m_map.drag(anywhere(), anywhere());
    }
    void move()
    {
        take(MapToolKind::Select);
        if (m_random.below(2) == 0)
            select();
        if (!m_map.scenario().icebergs.empty())
            m_map.drag(m_map.iceberg(m_random.below(m_map.scenario().icebergs.size())), anywhere());
    }
    void dragDrift()
    {
        take(MapToolKind::Select);
        select();
        MapScene scene;
        scene.setRect(QRectF(m_map.view.rect()));
        scene.setPicture(withScenario(MapFixture::plainPicture(), m_map.scenario()));
        scene.setView(m_map.view.view());
        const std::vector<MapHandle> handles = handlesOf(scene, m_map.selection);
        if (!handles.empty())
            m_map.drag(handles[m_random.below(handles.size())].at_px.toPoint(), anywhere());
    }
    void nudge()
    {
        take(MapToolKind::Select);
        select();
        const std::array keys{Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down};
        for (std::uint64_t n = 1 + m_random.below(4); n > 0; --n)
            key(keys[m_random.below(keys.size())],
                m_random.below(3) == 0 ? Qt::ShiftModifier : Qt::NoModifier);
    }
    void paste()
    {
        select();
        if (m_random.below(3) == 0) {
            m_map.view.edits().cutSelected();
            return;
        }
        m_map.view.edits().copySelected(); // or the icebergs cut before
        if (m_map.scenario().icebergs.size() < kMostIcebergs)
            m_map.view.edits().pasteAt(m_map.view.toWorld(anywhere()));
    }
    void duplicate()
    {
        select();
        if (m_map.scenario().icebergs.size() < kMostIcebergs)
            m_map.view.edits().duplicateSelected();
    }
    void remove()
    {
        select();
        key(Qt::Key_Delete);
    }
    void drawArea()
    {
        take(MapToolKind::Area);
        for (std::uint64_t n = 3 + m_random.below(4); n > 0; --n)
            m_map.click(anywhere());
        if (m_random.below(2) == 0)
            key(Qt::Key_Backspace);
        key(Qt::Key_Return);
        key(Qt::Key_Escape);
    }
    void moveCorner()
    {
        take(m_random.below(2) == 0 ? MapToolKind::Area : MapToolKind::Select);
        const std::vector<Point>& area_m = m_map.scenario().area_m;
        if (area_m.empty())
            return;
        m_map.selection.set({kAreaKey});
        const std::size_t corner = m_random.below(area_m.size());
        const Point& next_m = area_m[(corner + 1) % area_m.size()];
        if (m_random.below(4) == 0) {
            m_map.click(m_map.pixelOf(area_m[corner]));
            key(Qt::Key_Delete);
        } else if (m_random.below(2) == 0) {
            m_map.drag(m_map.pixelOf(area_m[corner]), anywhere());
        } else {
            m_map.drag(m_map.pixelOf((area_m[corner] + next_m) / 2), anywhere());
        }
        key(Qt::Key_Escape);
    }
    void slideTau()
    {
        for (std::uint64_t n = 1 + m_random.below(3); n > 0; --n) {
            const double tau = m_random.uniform(0, 5);
            m_map.document.edit(
                QStringLiteral("Tau"), [tau](Scenario& s) { s.planner.tau = tau; },
                QStringLiteral("tau"));
        }
        m_map.document.endGesture();
    }
    void change()
    {
        const double value = m_random.uniform(0, 1);
        const std::uint64_t which = m_random.below(6);
        m_map.document.edit(QStringLiteral("Settings"), [value, which](Scenario& s) {
            if (which == 0)
                s.wind_mps = {10 * value, -3};
            else if (which == 1)
                s.current_mps = {value, 0.1};
            else if (which == 2)
                s.seed = static_cast<std::int64_t>(1e6 * value);
            else if (which == 3)
                s.noise = !s.noise;
            else if (which == 4)
                s.notes = "note " + std::to_string(value);
            else
                s.origin.latitude_deg = 90 * value;
        });
    }
    void changeMany()
    {
        const double value = m_random.uniform(1, 9);
        m_map.document.edit(QStringLiteral("Table"), [value](Scenario& s) {
            for (Iceberg& iceberg : s.icebergs)
                iceberg.sigma0_m2 += value;
            s.notes += "t";
        });
    }
    void placeAsset()
    {
        take(MapToolKind::Asset);
        m_map.drag(anywhere(), anywhere());
    }
    void placeUav()
    {
        take(MapToolKind::Uav);
        m_map.drag(anywhere(), anywhere());
    }
    /** Edits as by typing in a field: each letter is an edit of one gesture. */
    void type()
    {
        for (std::uint64_t n = 1 + m_random.below(4); n > 0; --n)
            m_map.document.edit(
                QStringLiteral("Name"), [](Scenario& s) { s.name += "x"; }, QStringLiteral("name"));
        m_map.document.endGesture();
    }
    /** Makes drags that are cancelled. */
    void takeBack()
    {
        take(MapToolKind::Select);
        select();
        if (!m_map.scenario().icebergs.empty())
            m_map.drag(m_map.iceberg(0), m_random.below(2) == 0 ? QPoint(-50, 100) : anywhere(), {},
                       false);
        key(Qt::Key_Escape);
        m_map.release({-50, 100});
    }

    MapFixture& m_map;
    Random m_random;
    QSet<QString> m_all;
    QSet<QString> m_changed;
};

} // namespace berg::test
