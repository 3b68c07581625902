using System.Runtime.Intrinsics;

namespace Msisf.Core.Illumination;

/// <summary>Sums of the light of a place, sixteen steps at a time; <c>default</c> has no step.</summary>
internal struct LightSums
{
    private Vector512<float> _area;
    private PlaneSum _tracking;
    private PlaneSum _horizontal;
    private PlaneSum _fixed;

    /// <summary>Adds steps.</summary>
    /// <param name="area">Visible part of the Sun's disc.</param>
    /// <param name="tracking">W/m^2 on a plane that is turned to the Sun.</param>
    /// <param name="horizontal">W/m^2 on a horizontal plane.</param>
    /// <param name="onFixed">W/m^2 on the chosen plane.</param>
    public void Add(Vector512<float> area, Vector512<float> tracking, Vector512<float> horizontal, Vector512<float> onFixed)
    {
        _area += area;
        _tracking.Add(tracking);
        _horizontal.Add(horizontal);
        _fixed.Add(onFixed);
    }

    /// <summary>The light of a number of steps; those that were not added were dark.</summary>
    public readonly PlaceLight ToLight(int steps) => new()
    {
        DiscPart = Vector512.Sum(_area) / steps,
        Tracking = _tracking.Over(steps),
        Horizontal = _horizontal.Over(steps),
        Fixed = _fixed.Over(steps),
    };

    private struct PlaneSum
    {
        private Vector512<float> _sum;
        private Vector512<float> _most;

        public void Add(Vector512<float> flux)
        {
            _sum += flux;
            _most = Vector512.MaxNative(_most, flux);
        }

        public readonly Irradiance Over(int steps) => new(Vector512.Sum(_sum) / steps, LaneMasks.Max(_most));
    }
}
