"""Where each asked food joins a dish: the stages of a frame as spots, and the phases of an open pot or pan."""
