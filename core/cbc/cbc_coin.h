#pragma once

#include <ClpEventHandler.hpp>
#include <ClpSimplex.hpp>
#include <CoinMessageHandler.hpp>
#include <OsiClpSolverInterface.hpp>

#include <functional>
#include <utility>

// These classes keep COIN quiet and stop its solves in time.

namespace berg {

/** Returns true once the solve must end, and from then on. */
using CoinStop = std::function<bool()>;

/** Swallows all messages: CBC raises log levels by itself and aborts after severe messages. */
class SilentHandler final : public CoinMessageHandler
{
public:
    [[nodiscard]] CoinMessageHandler* clone() const override { return new SilentHandler(*this); }
    int print() override { return 0; }
    void checkSeverity() override {}
};

/** Stops a relaxation between two simplex iterations. */
class SimplexStopper final : public ClpEventHandler
{
public:
    explicit SimplexStopper(CoinStop stop) : m_stop(std::move(stop)) {}
    [[nodiscard]] ClpEventHandler* clone() const override { return new SimplexStopper(*this); }
    int event(Event which) override
    {
        constexpr int kContinue = -1;
        constexpr int kStop = 0;
        const bool asked = which == endOfIteration || which == endOfFactorization;
        return asked && m_stop() ? kStop : kContinue;
    }

private:
    CoinStop m_stop;
};

/**
 * A Clp that solves nothing after a stop. CBC then tidies up with several relaxations, each of
 * which would pay for its setup before consulting the stopper.
 */
class StoppableClp final : public OsiClpSolverInterface
{
public:
    explicit StoppableClp(CoinStop stop) : m_stop(std::move(stop)) {}
    [[nodiscard]] OsiSolverInterface* clone(bool copyData = true) const override
    {
        return copyData ? new StoppableClp(*this) : new StoppableClp(m_stop);
    }
    void initialSolve() override
    {
        if (!skipped())
            OsiClpSolverInterface::initialSolve();
    }
    void resolve() override
    {
        if (!skipped())
            OsiClpSolverInterface::resolve();
    }

private:
    bool skipped()
    {
        constexpr int kInfeasible = 1; // as an interrupted relaxation looks to CBC
        const bool skip = m_stop();
        if (skip)
            getModelPtr()->setProblemStatus(kInfeasible);
        return skip;
    }

    CoinStop m_stop;
};

} // namespace berg
