% Uses the emitted functions: answers a line for each line of points, asked as scalars and as arrays.
1;

function values = of(given, columns)
    values = cell2struct(num2cell(columns, 1)(:), given, 1);
end

function same = are_same(one, other)
    same = isequal(num2hex(one), num2hex(other)) || all(isnan(one) & isnan(other));
end

given.determinant = {"m_11", "m_12", "m_13", "m_21", "m_22", "m_23", "m_31", "m_32", "m_33"};
given.match = {"I", "lambda", "t1", "fn", "double", "unused"};
given.quadratic_form = {"a", "b", "c", "x", "y"};
given.rod = {"L", "cos_alpha_g_plus_theta_0", "sin_alpha_g_plus_theta_0", "cos_2_beta_minus_theta_0"};
given.angles = {"L", "theta_0", "beta"};

rows = struct();
while ischar(line = fgetl(stdin))
    words = strsplit(strtrim(line), " ");
    padded = cellfun(@(word) [repmat("0", 1, 16 - numel(word)), word], words(2:end), "UniformOutput", false);
    if ~isfield(rows, words{1})
        rows.(words{1}) = {};
    end
    rows.(words{1}){end + 1} = hex2num(char(padded))';
end

for name = fieldnames(rows)'
    name = name{1};
    if strcmp(name, "angles")
        name = "rod";
        names = given.angles;
        points = cell2mat(rows.angles');
    else
        names = given.(name);
        points = cell2mat(rows.(name)');
    end
    together = feval(name, of(names, points));
    fields = fieldnames(together)';
    % Sizes: the first input as a column, the others as rows.
    grid = of(names, points(1:4, :));
    for other = names(2:end)
        grid.(other{1}) = grid.(other{1})';
    end
    grid = feval(name, grid);
    for place = 1:size(points, 1)
        alone = feval(name, of(names, points(place, :)));
        answer = {};
        for field = fields
            value = alone.(field{1});
            assert(isscalar(value) && isa(value, "double") && isreal(value));
            assert(isequal(size(together.(field{1})), [size(points, 1), 1]));
            assert(isequal(size(grid.(field{1})), [4, 4]));
            assert(are_same(value, together.(field{1})(place)));
            if place <= 4
                assert(are_same(value, grid.(field{1})(place, place)));
            end
            answer{end + 1} = num2hex(value);
        end
        printf("%s\n", strjoin(answer, " "));
    end
end
