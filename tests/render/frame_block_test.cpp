// The frame block of a model that is rotated in the world.
#include "core/render/frame_block.hpp"

#include "tests/support/catch.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

using namespace meltpool;

TEST_CASE("the lamp stays where it is when the model is turned, moves with its place and grows with it", "[render]") {
    const LookParameters look;
    const auto lampOf = [&](const glm::mat4& modelToWorld) {
        SceneView scene;
        scene.modelToWorld = modelToWorld;
        return makeFrame(scene, look).lamp;
    };
    const glm::mat4 still(1);
    CHECK(glm::distance(lampOf(still), look.lightPosition) < 1e-6F);
    CHECK(glm::distance(lampOf(glm::rotate(still, 2.1F, {0, 0, 1})), look.lightPosition) < 1e-6F);
    const glm::mat4 elsewhere = glm::scale(glm::translate(still, {1, 2, 3}), glm::vec3(2));
    const glm::vec3 place = glm::vec3(1, 2, 3) + 2.0F * look.lightPosition;
    CHECK(glm::distance(lampOf(elsewhere), place) < 1e-5F);
    CHECK(glm::distance(lampOf(glm::rotate(elsewhere, 3.1F, {1, 0, 0})), place) < 1e-5F);
}
