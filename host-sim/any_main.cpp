// zstrip-any: the zstrip command with every pipeline. The command runs it if no common pipeline can draw a scene.
#include "cli/commands.hpp"
#include "zstrip/visibility.hpp"

int main(int argc, char** argv) {
  zstrip::use_visibility_methods();
  return zstrip::sim::run_command(argc, argv);
}
