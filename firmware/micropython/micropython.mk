# A user C module of MicroPython: make USER_C_MODULES=FOLDER, the folder in which this one is. ZSTRIP_EFFECTS: see flags.mk.
zstrip_folder := $(USERMOD_DIR)
zstrip_cxx = $(CXX)
include $(zstrip_folder)/flags.mk
# $(wildcard) takes no folders in folders: four levels of them.
zstrip_levels := $(addprefix $(zstrip_folder)/cpp/,*/*.cpp */*/*.cpp */*/*/*.cpp */*/*/*/*.cpp)

SRC_USERMOD_C += $(zstrip_folder)/zstrip_module.c
SRC_USERMOD_LIB_CXX += $(zstrip_folder)/pipeline.cpp $(wildcard $(zstrip_levels))
CFLAGS_USERMOD += -I$(zstrip_folder)/cpp

# After the flags of the port, some of which make constants less exact, and for these files alone.
zstrip_flags += -O2 -fno-single-precision-constant -Wno-double-promotion -Wno-float-conversion
$(BUILD)/$(notdir $(zstrip_folder))/%.o: CXXFLAGS += $(zstrip_flags)
