#include <gmock/gmock.h>

#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/domain/model/symbolic_model.hpp"
#include "fuzz/damage.hpp"
#include "planners/learned_world.hpp"

namespace conceptplan {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(SymbolicModelFuzz, DamagedTextsAreRefusedOrAWholeModel) {
  std::size_t refused = 0;
  testing::forEachDamage(toJson(testing::learnedModel()), 150, 400, 5,
                         [&](const std::string& text, const std::string& what) {
                           SCOPED_TRACE(what);
                           try {
                             const SymbolicModel model = parseSymbolicModel(text, "m");
                             EXPECT_EQ(parseSymbolicModel(toJson(model), "m"), model);
                             EXPECT_TRUE(model.grounding.faults(model.cardinality()).empty());
                           } catch (const InputError&) {
                             ++refused;
                           }
                         });
  EXPECT_GT(refused, 300U);
}

TEST(SymbolicModelFuzz, HostileTextsAreNamed) {
  const std::string deep(200'000, '[');
  EXPECT_THAT([&] { parseSymbolicModel(deep, "m"); },
              ThrowsMessage<InputError>(HasSubstr("nested too deeply")));
  EXPECT_THAT([&] { parseSymbolicModel("{\"version\": 1e999}", "m"); },
              ThrowsMessage<InputError>(HasSubstr("beyond the range")));
  std::string text = toJson(testing::learnedModel());
  const std::size_t columns = text.find('0', text.find("\"columns\""));
  text.replace(columns, 1, "4294967296");  // 0 in 32 bits
  EXPECT_THAT([&] { parseSymbolicModel(text, "m"); },
              ThrowsMessage<InputError>(HasSubstr("expected at most 1000000")));
}

}  // namespace
}  // namespace conceptplan
