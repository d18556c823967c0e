"""Cross-sections of parallel grooves with rock that breaks out, in columns; shares no code with TDBD."""

import numpy as np

DIAMETER, RAKE, DEPTH, SIDES = 13e-3, np.radians(15.0), 3e-3, 64


class Rock:
    """Flat rock in columns, in which a polygonal face cuts parallel grooves."""

    def __init__(self, half_width=35e-3, columns=28001):
        self.y = np.linspace(-half_width, half_width, columns)
        self.bottom = np.zeros(columns)

    def face(self, middle):
        """Depth of the face's edge."""
        turns = 2.0 * np.pi * np.arange(-SIDES // 4, SIDES // 4 + 1) / SIDES
        y, z = 0.5 * DIAMETER * np.sin(turns), 0.5 * DIAMETER * (1.0 - np.cos(turns)) * np.cos(RAKE)
        return DEPTH - np.interp(self.y - middle, y, z, left=np.inf, right=np.inf)

    def groove(self, middle, angle, share, ahead):
        """Areas that the face cuts, and that break out ahead of and beside it, m2. Angle in degrees; 0: nothing breaks out."""
        before, face, width = self.bottom.copy(), self.face(middle), self.y[1] - self.y[0]
        engaged, height = face > before, DEPTH - face
        tops = [height[engaged & side].max(initial=0.0) for side in (self.y <= middle, self.y > middle)]
        chipped = np.maximum(0.0, face - (1.0 - ahead) * max(tops) - before) if ahead > 0.0 else np.zeros_like(face)
        cut = np.maximum(0.0, face - before) - chipped
        self.bottom = np.maximum(before, face)
        groove = self.bottom.copy()
        if angle > 0.0 and share > 0.0:
            for k in np.flatnonzero(engaged):
                right = self.y[k] > middle
                if height[k] < (1.0 - share) * tops[int(right)]:
                    continue
                way = (self.y - self.y[k]) * (1.0 if right else -1.0)
                crack = np.where((way > 0.0) & (way < (tops[int(right)] - height[k]) * np.tan(np.radians(angle))), face[k] - way / np.tan(np.radians(angle)), -np.inf)
                self.bottom = np.maximum(self.bottom, crack)
        return [float(a.sum() * width) for a in (cut, chipped, self.bottom - groove)]
