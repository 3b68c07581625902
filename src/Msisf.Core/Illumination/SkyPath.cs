using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Illumination;

/// <summary>
/// The path of a body in the sky of a place, and of places near it: to first order in their distance, which is kept so small that the
/// second order is far below the error of a horizon. Not safe for several threads.
/// </summary>
internal sealed class SkyPath
{
    private readonly LightTimes _times;
    private readonly int _columns;
    private readonly double _reach;
    private readonly float[] _east;
    private readonly float[] _north;
    private readonly float[] _up;
    private readonly float[] _tangent;
    private readonly float[] _column;
    private readonly float[] _rise;
    private readonly float[] _turn;
    private readonly SkyBox[] _boxes;
    private LocalFrame _middle;
    private bool _isPlaced;

    /// <summary>Makes a path.</summary>
    /// <param name="times">Where the body is.</param>
    /// <param name="columns">Columns of a turn.</param>
    /// <param name="steepest">Tangent of the greatest elevation that matters.</param>
    public SkyPath(LightTimes times, int columns, double steepest)
    {
        const double Reach = 1e-3; // rad; its square is 6e-5 degrees
        (_times, _columns, _reach) = (times, columns, Reach / (1.0 + (steepest * steepest)));
        int count = times.X.Length;
        (_east, _north, _up) = (new float[count], new float[count], new float[count]);
        _boxes = new SkyBox[count / LightTimes.Lanes];
        (_tangent, _column, _rise, _turn) = (new float[count], new float[count], new float[count], new float[count]);
    }

    /// <summary>Forgets the place.</summary>
    public void Forget() => _isPlaced = false;

    /// <summary>Moves the path to a place, unless it is near enough.</summary>
    /// <param name="frame">The place.</param>
    /// <returns>How the path is seen from there.</returns>
    public SkyShift MoveTo(in LocalFrame frame)
    {
        if (!_isPlaced || (frame.Up - _middle.Up).Length > _reach)
        {
            (_isPlaced, _middle) = (true, frame);
            Fill();
            for (int block = 0; block < _boxes.Length; block++)
            {
                _boxes[block] = BoxOf(block);
            }
        }

        Vector3D up = _middle.ToLocal(frame.Up);
        double turns = Math.Atan2(Vector3D.Dot(_middle.North, frame.East), Vector3D.Dot(_middle.North, frame.North)) / (2.0 * Math.PI);
        return new SkyShift((float)up.X, (float)up.Y, (float)((turns < 0.0 ? turns + 1.0 : turns) * _columns));
    }

    /// <summary>The body at sixteen steps: tangent of its elevation, and its azimuth in columns, to twice a turn.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public SeenBody At(int step, in SkyShift shift)
    {
        Vector512<float> east = ArrayLanes.Load(_east, step);
        Vector512<float> north = ArrayLanes.Load(_north, step);
        Vector512<float> tiltEast = Vector512.Create(shift.TiltEast);
        Vector512<float> tiltNorth = Vector512.Create(shift.TiltNorth);
        return SeenAt(
            ArrayLanes.Load(_tangent, step)
                + (ArrayLanes.Load(_rise, step) * ((tiltEast * east) + (tiltNorth * north))),
            ArrayLanes.Load(_column, step) + Vector512.Create(shift.Columns)
                + (ArrayLanes.Load(_turn, step) * ((tiltNorth * east) - (tiltEast * north))),
            ArrayLanes.Load(_times.Slope, step));
    }

    /// <summary>The body from its place in the sky.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public SeenBody SeenAt(Vector512<float> tangent, Vector512<float> column, Vector512<float> slope)
    {
        Vector512<float> perCosine = Vector512.Sqrt(Vector512<float>.One + (tangent * tangent));
        return new SeenBody(
            tangent, column, slope, perCosine, slope * perCosine * Vector512.Create((float)(_columns / (2.0 * Math.PI))));
    }

    /// <summary>Limits of the body's disc at sixteen steps.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public SkyBox BoxAt(int step, in SkyShift shift)
    {
        ref readonly SkyBox box = ref _boxes[step / LightTimes.Lanes];
        return box with { First = box.First + shift.Columns };
    }

    private SkyBox BoxOf(int block)
    {
        int from = block * LightTimes.Lanes;
        (float first, float last) = (0.0f, 0.0f);
        (float lowest, float highest) = (float.PositiveInfinity, float.NegativeInfinity);
        for (int step = from; step < from + LightTimes.Lanes; step++)
        {
            float along = _column[step] - _column[from];
            along -= _columns * MathF.Round(along / _columns);
            (first, last) = (Math.Min(first, along), Math.Max(last, along));
            (lowest, highest) = (Math.Min(lowest, _tangent[step]), Math.Max(highest, _tangent[step]));
        }

        // What a tilt of at most the reach adds; and the disc, as of single steps.
        float steepest = Math.Max(Math.Abs(lowest), Math.Abs(highest)) + 0.1f; // the Earth's parallax is 0.02
        float turn = 1.0f + (1.1f * (float)_reach * steepest * (float)(_columns / (2.0 * Math.PI)));
        float half = ((1.05f * (_times.MaxSlope + ExactLight.Doubt)) + (1.5f * (float)_reach)) * (1.0f + (steepest * steepest));
        return new SkyBox(_column[from] + first - turn, last - first + (2.0f * turn), lowest - half, highest + half);
    }

    /// <summary>Components of a direction along the axes of the place to which the path was moved last.</summary>
    /// <param name="bodyFixed">Body-fixed.</param>
    public Vector3D ToLocal(Vector3D bodyFixed) => _middle.ToLocal(bodyFixed);

    /// <summary>Cosines of the angles between a normal and the directions to the body at sixteen steps.</summary>
    /// <param name="normal">As <see cref="ToLocal"/> gives it, length 1.</param>
    /// <param name="step">The first step.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector512<float> CosineTo(Vector3D normal, int step) => Along(
        normal, ArrayLanes.Load(_east, step), ArrayLanes.Load(_north, step), ArrayLanes.Load(_up, step));

    /// <summary>The same at steps anywhere.</summary>
    public Vector512<float> CosineTo(Vector3D normal, Vector512<int> steps) => Along(
        normal, HorizonTable.Gather(_east, steps), HorizonTable.Gather(_north, steps), HorizonTable.Gather(_up, steps));

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void Fill()
    {
        Vector512<float> least = Vector512.Create(1e-6f);
        for (int step = 0; step < _times.X.Length; step += LightTimes.Lanes)
        {
            Vector512<float> x = ArrayLanes.Load(_times.X, step);
            Vector512<float> y = ArrayLanes.Load(_times.Y, step);
            Vector512<float> z = ArrayLanes.Load(_times.Z, step);
            Vector512<float> east = Along(_middle.East, x, y, z);
            Vector512<float> north = Along(_middle.North, x, y, z);
            Vector512<float> far = Along(_middle.Up, x, y, z);
            Vector512<float> up = far - (Vector512.Create((float)_middle.PositionBodyFixed.Length)
                * ArrayLanes.Load(_times.PerMetre, step));
            Vector512<float> across = Vector512.MaxNative(Vector512.Sqrt((east * east) + (north * north)), least);
            Vector512<float> length = Vector512.Sqrt((across * across) + (up * up));
            Vector512<float> tangent = up / across;
            tangent.StoreTo(_tangent, step);
            (AzimuthLanes.Turns(east, north) * Vector512.Create((float)_columns)).StoreTo(_column, step);
            (east / length).StoreTo(_east, step);
            (north / length).StoreTo(_north, step);
            (up / length).StoreTo(_up, step);

            // A tilt of the ground turns the body's direction, not its parallax.
            (length / across * (Vector512<float>.One + (tangent * far / across))).StoreTo(_rise, step);
            (length * far / (across * across) * Vector512.Create((float)(_columns / (2.0 * Math.PI)))).StoreTo(_turn, step);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<float> Along(Vector3D axis, Vector512<float> x, Vector512<float> y, Vector512<float> z) =>
        (Vector512.Create((float)axis.X) * x) + (Vector512.Create((float)axis.Y) * y) + (Vector512.Create((float)axis.Z) * z);
}

/// <summary>How a path in the sky is seen from a place near that to which it was moved.</summary>
/// <param name="TiltEast">rad: how far up leans to the east.</param>
/// <param name="TiltNorth">rad: how far up leans to the north.</param>
/// <param name="Columns">By how much azimuths are greater, in columns.</param>
internal readonly record struct SkyShift(float TiltEast, float TiltNorth, float Columns);

/// <summary>Limits of a body's disc at some steps, but for its width.</summary>
/// <param name="First">Least azimuth, in columns.</param>
/// <param name="Width">Columns from there to the greatest.</param>
/// <param name="Lowest">Tangent of the least elevation of its lower edge.</param>
/// <param name="Highest">Tangent of the greatest elevation of its upper edge.</param>
internal readonly record struct SkyBox(float First, float Width, float Lowest, float Highest);
