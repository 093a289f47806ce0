#pragma once

// The views of `tradeoff`, each in the file of its name.

#include "tools/report/view.h"
#include "tools/tradeoff/tradeoff.h"

namespace raycheck::tools {

std::string tradeoff_text(const TradeoffReport& report, const ViewOptions& options);
std::string tradeoff_json(const TradeoffReport& report, const ViewOptions& options);
std::string tradeoff_csv(const TradeoffReport& report, const ViewOptions& options);
std::string tradeoff_markdown(const TradeoffReport& report, const ViewOptions& options);

inline constexpr View<TradeoffReport> kTradeoffViews[] = {
    {"text", tradeoff_text},
    {"json", tradeoff_json},
    {"csv", tradeoff_csv},
    {"markdown", tradeoff_markdown},
};

}  // namespace raycheck::tools
