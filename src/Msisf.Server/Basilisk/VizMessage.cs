using Google.Protobuf;

namespace Msisf.Server.Basilisk;

/// <summary>What Basilisk's vizInterface says of a moment: the fields of its VizMessage that an image depends on.</summary>
internal sealed record VizMessage
{
    /// <summary>s since the epoch.</summary>
    public double SimulationSeconds { get; init; }

    /// <summary>UTC, which only the first message of a simulation has; null in the others.</summary>
    public VizEpoch? Epoch { get; init; }

    public required IReadOnlyList<VizBody> Bodies { get; init; }

    public required IReadOnlyList<VizSpacecraft> Spacecraft { get; init; }

    public required IReadOnlyList<VizCamera> Cameras { get; init; }
}

/// <summary>A date and time of the calendar, UTC.</summary>
internal sealed record VizEpoch(int Year, int Month, int Day, int Hours, int Minutes, double Seconds);

/// <summary>A celestial body.</summary>
/// <param name="Position">m, in the simulation's inertial axes N.</param>
/// <param name="BodyFromInertial">The nine numbers of the matrix that turns components of N into the body's, row by row.</param>
internal sealed record VizBody(string Name, Vector3D Position, IReadOnlyList<double> BodyFromInertial);

/// <summary>A spacecraft.</summary>
/// <param name="Position">m, N.</param>
/// <param name="Attitude">Modified Rodrigues parameters of the craft's axes B relative to N.</param>
internal sealed record VizSpacecraft(string Name, Vector3D Position, Vector3D Attitude);

/// <summary>A camera.</summary>
/// <param name="Parent">Name of its spacecraft; empty for the only one.</param>
/// <param name="FieldOfViewDegrees">Vertical, from edge to edge.</param>
/// <param name="Width">px.</param>
/// <param name="Height">px.</param>
/// <param name="Position">m, in the craft's axes B.</param>
/// <param name="Direction">Modified Rodrigues parameters of Unity's camera axes relative to B.</param>
/// <param name="RenderMode">0 for an image, 1 for a map of depths.</param>
internal sealed record VizCamera(
    long Id, string Parent, double FieldOfViewDegrees, long Width, long Height, Vector3D Position, Vector3D Direction, int RenderMode);

/// <summary>
/// Reads the protobuf of Basilisk's vizInterface: the fields of clients/basilisk/vizard.proto, which kept their numbers from Basilisk 1.8
/// to 2.12. All other fields are left out.
/// </summary>
internal static class VizMessageReader
{
    private const double SecondsPerNanosecond = 1e-9;

    /// <exception cref="BadInputException">The bytes are not such a message.</exception>
    public static VizMessage Read(byte[] bytes)
    {
        try
        {
            Fields message = new(ByteString.CopyFrom(bytes));
            return new VizMessage
            {
                SimulationSeconds = SecondsPerNanosecond * (message.Nested(1).LastOrDefault()?.Real(2) ?? 0.0),
                Epoch = message.Nested(8).Select(epoch => new VizEpoch(
                    (int)epoch.Whole(1), (int)epoch.Whole(2), (int)epoch.Whole(3), (int)epoch.Whole(4), (int)epoch.Whole(5), epoch.Real(6)))
                    .LastOrDefault(),
                Bodies = [.. message.Nested(2).Select(body => new VizBody(body.Text(1), body.Vector(2), body.Reals(4)))],
                Spacecraft = [.. message.Nested(3).Select(craft => new VizSpacecraft(craft.Text(1), craft.Vector(2), craft.Vector(4)))],
                Cameras = [.. message.Nested(4).Select(CameraOf)],
            };
        }
        catch (Exception exception) when (exception is InvalidProtocolBufferException or InvalidOperationException)
        {
            throw new BadInputException($"the message is not a VizMessage of Basilisk: {exception.Message}", exception);
        }
    }

    private static VizCamera CameraOf(Fields camera)
    {
        List<long> resolution = camera.Wholes(4);
        return new VizCamera(
            camera.Whole(1), camera.Text(2), camera.Real(3), resolution.ElementAtOrDefault(0), resolution.ElementAtOrDefault(1),
            camera.Vector(7), camera.Vector(8), (int)camera.Whole(16));
    }

    /// <summary>The fields of one message by their numbers; one that is missing is 0 or empty, as protobuf has it.</summary>
    private sealed class Fields
    {
        private readonly Dictionary<int, List<object>> _values = [];

        public Fields(ByteString message)
        {
            using CodedInputStream input = message.CreateCodedInput();
            for (uint tag = input.ReadTag(); tag != 0; tag = input.ReadTag())
            {
                object? value = WireFormat.GetTagWireType(tag) switch
                {
                    WireFormat.WireType.Varint => input.ReadInt64(),
                    WireFormat.WireType.Fixed64 => input.ReadDouble(),
                    WireFormat.WireType.LengthDelimited => input.ReadBytes(),
                    _ => null,
                };
                if (value is null)
                {
                    input.SkipLastField();
                    continue;
                }

                int number = WireFormat.GetTagFieldNumber(tag);
                if (!_values.TryGetValue(number, out List<object>? values))
                {
                    _values.Add(number, values = []);
                }

                values.Add(value);
            }
        }

        public IEnumerable<Fields> Nested(int number) => All<ByteString>(number).Select(bytes => new Fields(bytes));

        public string Text(int number) => All<ByteString>(number).LastOrDefault()?.ToStringUtf8() ?? string.Empty;

        public double Real(int number) => All<double>(number).LastOrDefault();

        public long Whole(int number) => All<long>(number).LastOrDefault();

        /// <summary>Repeated numbers, packed into one field or each in a field of its own.</summary>
        public List<double> Reals(int number) => Repeated(number, input => input.ReadDouble());

        /// <inheritdoc cref="Reals"/>
        public List<long> Wholes(int number) => Repeated(number, input => input.ReadInt64());

        /// <summary>Three numbers; those that are missing are 0.</summary>
        public Vector3D Vector(int number)
        {
            List<double> numbers = Reals(number);
            return new Vector3D(numbers.ElementAtOrDefault(0), numbers.ElementAtOrDefault(1), numbers.ElementAtOrDefault(2));
        }

        private List<T> Repeated<T>(int number, Func<CodedInputStream, T> read)
        {
            List<T> numbers = [];
            foreach (object value in _values.GetValueOrDefault(number) ?? [])
            {
                if (value is T single)
                {
                    numbers.Add(single);
                }
                else if (value is ByteString packed)
                {
                    using CodedInputStream input = packed.CreateCodedInput();
                    while (!input.IsAtEnd)
                    {
                        numbers.Add(read(input));
                    }
                }
            }

            return numbers;
        }

        private IEnumerable<T> All<T>(int number) => _values.GetValueOrDefault(number)?.OfType<T>() ?? [];
    }
}
